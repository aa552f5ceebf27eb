#include "base/text/cells.h"

#include <gmock/gmock.h>

#include "base/text/trim.h"

namespace text {
namespace {

using testing::ElementsAre;

TEST(Trimmed, LosesBlanksAtBothEndsAndStaysInItsText) {
  EXPECT_EQ(Trimmed(" \ta b\r\n"), "a b");
  const std::string_view blank = "  ";
  EXPECT_EQ(Trimmed(blank), "");
  EXPECT_EQ(Trimmed(blank).data(), blank.data() + 2);
}

TEST(CellsOf, StandBetweenCommas) {
  EXPECT_THAT(CellsOf(" time [s] ,x,, \"a b\" ,\" 2 \"\r"),
              ElementsAre("time [s]", "x", "", "a b", "2"));
  EXPECT_THAT(CellsOf(""), ElementsAre(""));
  EXPECT_THAT(CellsOf("1,"), ElementsAre("1", ""));
  EXPECT_THAT(CellsOf("\""), ElementsAre("\""));
}

TEST(ReadNumber, TakesTheWholeCell) {
  double number = 0;
  EXPECT_EQ(ReadNumber("-2.5e-1", number), std::errc());
  EXPECT_EQ(number, -0.25);
  EXPECT_EQ(ReadNumber("+3", number), std::errc());
  EXPECT_EQ(number, 3);
  for (const char* text : {"", "x", "1;", "1 2", "0x"})
    EXPECT_EQ(ReadNumber(text, number), std::errc::invalid_argument) << text;
  for (const char* text : {"1e999", "-1e999", "1e-999"})
    EXPECT_EQ(ReadNumber(text, number), std::errc::result_out_of_range) << text;
}

}  // namespace
}  // namespace text
