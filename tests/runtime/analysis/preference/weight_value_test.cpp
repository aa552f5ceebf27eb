#include "runtime/analysis/preference/weight_value.h"

#include <gmock/gmock.h>

namespace runtime {
namespace {

TEST(RoundWeight, KeepsThreeDigits) {
  EXPECT_EQ(RoundWeight(6.34567, -1000, 1000, false), 6.35);
  EXPECT_EQ(RoundWeight(0.0123456, -1000, 1000, false), 0.0123);
  EXPECT_EQ(RoundWeight(-123.456, -1000, 1000, false), -123);
}

TEST(RoundWeight, StaysInTheRange) {
  EXPECT_EQ(RoundWeight(9.9951, 1.2349, 9.9951, false), 9.9951);  // not 10
  EXPECT_EQ(RoundWeight(1.2349, 1.2349, 9.9951, false), 1.2349);
}

TEST(RoundWeight, WholeNumbersStayWholeAndOnTheirSideOfZero) {
  EXPECT_EQ(RoundWeight(2.6, -10, 10, true), 3);
  EXPECT_EQ(RoundWeight(0.1, -10, 10, true), 1);
  EXPECT_EQ(RoundWeight(-0.1, -10, 10, true), -1);
}

TEST(ValueText, IsWhatTheLanguageReads) {
  EXPECT_EQ(ValueText(6.35, ""), "6.35");
  EXPECT_EQ(ValueText(-2, "m"), "-2 m");
  EXPECT_EQ(ValueText(0.05, "kg m/s"), "0.05 kg*m/s");
  EXPECT_EQ(ValueText(4, "1/s^2"), "4 / s^2");
}

}  // namespace
}  // namespace runtime
