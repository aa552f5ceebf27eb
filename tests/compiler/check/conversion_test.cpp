#include "compiler/check/conversion.h"

#include "compiler/check/unit.h"
#include "tests/compiler/check/checked_source.h"

namespace compiler {
namespace {

Unit UnitOf(std::string_view text) { return ParseUnit(text)->unit; }

TEST(UnitHelp, ForALiteralWritesItsUnit) {
  Expression twenty{{}, NumberLiteral{20, true, std::nullopt}};
  EXPECT_EQ(HelpForUnit({}, &twenty, UnitOf("s")).text, "write the number with its unit: `20 s`");
  EXPECT_EQ(HelpForUnit({}, &twenty, UnitOf("rad")).text, "write `20 deg` or `20 rad`");
}

TEST(UnitHelp, ForAnAngleDividesByTheRadian) {
  EXPECT_EQ(HelpForUnit(UnitOf("rad"), nullptr, {}).text,
            "an angle is not a plain number: divide by `1 rad`");
  EXPECT_EQ(HelpForUnit(UnitOf("m/s"), nullptr, UnitOf("m rad/s")).text,
            "an angle is not a plain number: multiply by `1 rad`");
  EXPECT_EQ(HelpForUnit(UnitOf("rad^2"), nullptr, {}).text,
            "an angle is not a plain number: divide by `1 rad^2`");
}

TEST(UnitHelp, IsSilentWhereNothingGeneralCanBeSaid) {
  EXPECT_EQ(HelpForUnit(UnitOf("m"), nullptr, UnitOf("s")).text, "");
}

TEST(LiteralZero, IsAZeroWithoutUnitOrSign) {
  Expression zero{{}, NumberLiteral{0, true, std::nullopt}};
  Expression one{{}, NumberLiteral{1, true, std::nullopt}};
  Expression zero_seconds{{}, NumberLiteral{0, true, UnitExpression{}}};
  EXPECT_TRUE(IsLiteralZero(&zero));
  EXPECT_FALSE(IsLiteralZero(&one));
  EXPECT_FALSE(IsLiteralZero(&zero_seconds));
  EXPECT_FALSE(IsLiteralZero(nullptr));
}

}  // namespace
}  // namespace compiler
