#include "compiler/check/fold.h"

#include <cmath>

#include "tests/compiler/check/checked_source.h"

namespace compiler {
namespace {

struct Case {
  const char* expression;
  double value;
};

class FoldedValue : public testing::TestWithParam<Case> {};

TEST_P(FoldedValue, IsTheOneCalculatedByHand) {
  const auto value = ValueOf(CheckText(GetParam().expression));
  ASSERT_TRUE(value) << GetParam().expression;
  EXPECT_DOUBLE_EQ(*value, GetParam().value) << GetParam().expression;
}

INSTANTIATE_TEST_SUITE_P(Arithmetic, FoldedValue,
                         testing::Values(Case{"2 + 3 * 4", 14}, Case{"7 - 10", -3},
                                         Case{"1 / 4", 0.25}, Case{"-(2)", -2},
                                         Case{"0.25 / 5 ms", 50}, Case{"-4e-9 / 0.2 ms", -2e-5},
                                         Case{"2 * 3.5", 7},
                                         Case{"90 deg / 1 rad", 1.5707963267948966}));

INSTANTIATE_TEST_SUITE_P(
    NewFunctions, FoldedValue,
    testing::Values(
        Case{"tan(45 deg)", 1}, Case{"asin(1) / 1 rad", 1.5707963267948966},
        Case{"acos(-1) / 1 rad", 3.1415926535897931}, Case{"atan(1) / 1 rad", 0.78539816339744831},
        Case{"pow(2, -3)", 0.125}, Case{"sign(-3 m)", -1}, Case{"sign(0.0)", 0}, Case{"sign(4)", 1},
        Case{"floor(-1.5)", -2}, Case{"ceil(-1.5)", -1}, Case{"round(-1.5)", -2},
        Case{"round(0.5)", 1}, Case{"select(1 < 2, 3, 4)", 3}, Case{"select(1 > 2, 3, 4.5)", 4.5},
        Case{"wrap(180 deg) / 1 rad", 3.1415926535897931}, Case{"wrap(-180 deg) / 1 deg", 180},
        Case{"wrap(4 rad) / 1 rad", -2.2831853071795862}, Case{"tolerance(3, 2, 4, 1)", 1},
        Case{"tolerance(5, 2, 4, 1)", 0.1}, Case{"tolerance(0, 2, 4, 2)", 0.1}));

INSTANTIATE_TEST_SUITE_P(Logic, FoldedValue,
                         testing::Values(Case{"1 < 2", 1}, Case{"2 <= 1", 0}, Case{"2 > 1", 1},
                                         Case{"1 >= 2", 0}, Case{"1 == 1.0", 1}, Case{"1 != 1", 0},
                                         Case{"true and false", 0}, Case{"true or false", 1},
                                         Case{"not true", 0}, Case{"true == false", 0},
                                         Case{"1 m > 99 cm", 1}, Case{"contact[head] and false", 0},
                                         Case{"true or contact[head]", 1}));

INSTANTIATE_TEST_SUITE_P(Functions, FoldedValue,
                         testing::Values(Case{"abs(-3)", 3}, Case{"min(2, 1)", 1},
                                         Case{"max(1, 3, 2)", 3}, Case{"clamp(5, 0, 2)", 2},
                                         Case{"clamp(-5, 0, 2)", 0}, Case{"sqrt(9 m^2)", 3},
                                         Case{"exp(0)", 1}, Case{"log(1)", 0}, Case{"tanh(0)", 0},
                                         Case{"sin(90 deg)", 1}, Case{"cos(180 deg)", -1},
                                         Case{"atan2(1, 1)", 0.78539816339744831},
                                         Case{"sum(3)", 3}, Case{"count(true)", 1},
                                         Case{"any(false)", 0}, Case{"all(true)", 1},
                                         Case{"none(true)", 0}));

TEST(Fold, LeavesWhatDependsOnTheRun) {
  EXPECT_FALSE(ValueOf(CheckText("contact[head] and true")));
  EXPECT_FALSE(ValueOf(CheckText("time * 0")));
  EXPECT_FALSE(ValueOf(CheckText("gain", "param gain: real = 1")));
}

TEST(Fold, FoldsTheConstantPartOfAProduct) {
  const CheckedExpression product = CheckText("0.25 / 5 ms * base.position.z");
  const auto& binary = std::get<CheckedBinary>(product.node);
  EXPECT_EQ(ValueOf(*binary.left), 50);
  EXPECT_EQ(ToString(binary.left->unit), "1/s");
}

TEST(Fold, KeepsTypeAndUnit) {
  EXPECT_EQ(TypeOf("2 m + 3 m"), "real [m]");
  EXPECT_EQ(TypeOf("2 + 3"), "int");
  EXPECT_EQ(TypeOf("sqrt(4 m^2)"), "real [m]");
}

}  // namespace
}  // namespace compiler
