#include "compiler/task_tests/value_text.h"

#include <gtest/gtest.h>

#include <limits>

#include "compiler/check/type.h"

namespace compiler {
namespace {

TEST(ValueText, ShowsScalarsWithTheirUnits) {
  EXPECT_EQ(ToString(Reals{-4}, ScalarType(Scalar::kReal), {}), "-4");
  EXPECT_EQ(ToString(Reals{1.5}, ScalarType(Scalar::kReal), {.meter = 1, .second = -1}), "1.5 m/s");
  EXPECT_EQ(ToString(Integers{3}, ScalarType(Scalar::kInt), {}), "3");
  EXPECT_EQ(ToString(Integers{1}, ScalarType(Scalar::kBool), {}), "true");
}

TEST(ValueText, ShowsAllElements) {
  EXPECT_EQ(ToString(Reals{0, 0, 1}, *FindType("vec3"), {.meter = 1}), "(0, 0, 1) m");
  const Type bools{Scalar::kBool, Shape::kArray, 2, 1, ""};
  EXPECT_EQ(ToString(Integers{0, 1}, bools, {}), "(false, true)");
}

TEST(ValueText, NamesWhatIsNoNumber) {
  using Limits = std::numeric_limits<double>;
  const Type vec2 = *FindType("vec2");
  EXPECT_EQ(ToString(Reals{Limits::quiet_NaN(), -Limits::infinity()}, vec2, {}),
            "(not a number, -infinity)");
}

}  // namespace
}  // namespace compiler
