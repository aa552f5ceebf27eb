#include "compiler/emit/cpp_literal.h"

#include <gtest/gtest.h>

#include <limits>

namespace compiler {
namespace {

TEST(CppLiteral, EscapesWhatWouldEndOrChangeAText) {
  EXPECT_EQ(StringLiteral("say \"a\\b\"\n"), R"("say \"a\\b\"\n")");
}

TEST(CppLiteral, BreaksTrigraphs) {
  EXPECT_EQ(StringLiteral("what?\?/ never?\?!"), R"("what?\?/ never?\?!")");
  EXPECT_EQ(StringLiteral("????"), R"("?\?\?\?")");
}

TEST(CppLiteral, WritesOtherBytesAsThreeOctalDigits) {
  EXPECT_EQ(StringLiteral(std::string_view("\x01"
                                           "7\0\xC3\xA4\r\t",
                                           7)),
            R"("\0017\000\303\244\015\011")");
}

TEST(CppLiteral, SplitsATextAtItsLines) {
  EXPECT_EQ(SplitStringLiteral("one\n\nthree", "  "), "  \"one\\n\"\n  \"\\n\"\n  \"three\"");
  EXPECT_EQ(SplitStringLiteral("one\n", "  "), "  \"one\\n\"");
  EXPECT_EQ(SplitStringLiteral("", "  "), "  \"\"");
}

TEST(CppLiteral, RealsReadBackAsTheSameNumberAndAreNoInts) {
  for (double value : {0.1, 1.0 / 3, 4.0, 1e22, 2.3e-308, -0.025, 1.7976931348623157e308}) {
    std::string literal = RealLiteral(value);
    EXPECT_EQ(std::stod(literal), value) << literal;
    EXPECT_NE(literal.find_first_of(".e"), std::string::npos) << literal;
  }
  EXPECT_EQ(RealLiteral(0.1), "0.1");
  EXPECT_EQ(RealLiteral(-0.0), "-0.0");
  EXPECT_EQ(RealLiteral(-std::numeric_limits<double>::infinity()), "-__builtin_inf()");
}

TEST(CppLiteral, IntsAreOfTheLongestType) {
  EXPECT_EQ(IntLiteral(-3), "-3LL");
  EXPECT_EQ(IntLiteral(9007199254740992.0), "9007199254740992LL");
}

}  // namespace
}  // namespace compiler
