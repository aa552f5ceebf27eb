#include "base/text/print.h"

#include <gtest/gtest.h>

namespace text {
namespace {

TEST(Visible, LeavesTextAsItIs) {
  const std::string text = "f\u00fcr \u05e2\u05d1\u05e8\u05d9\u05ea \U0001F600 100 %\n\ta\\b \"c\"";
  EXPECT_EQ(Visible(text), text);
  EXPECT_EQ(Visible(""), "");
}

TEST(Visible, ShowsWhatATerminalWouldObey) {
  EXPECT_EQ(Visible("a\x1b[31mred"), "a\\u001b[31mred");
  EXPECT_EQ(Visible(std::string_view("a\0b\r\x7f", 5)), "a\\u0000b\\u000d\\u007f");
  EXPECT_EQ(Visible("\u009b2J"), "\\u009b2J");
  EXPECT_EQ(Visible("\u202egnp.exe"), "\\u202egnp.exe");
}

// A byte that is no UTF-8 is an escape sequence to terminals of eight bits.
TEST(Visible, ShowsBytesThatAreNoCharacters) {
  EXPECT_EQ(Visible("a\x9b\x32J\xff"), "a\\x9b2J\\xff");
}

TEST(Print, PrintsWhatIsVisible) {
  testing::internal::CaptureStdout();
  Print("{} {}\n", "\x1b", 7);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "\\u001b 7\n");
  testing::internal::CaptureStderr();
  Print(stderr, "{}", "\u2066");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "\\u2066");
}

}  // namespace
}  // namespace text
