#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "compiler/source/diagnostic.h"

namespace compiler {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string RenderOne(const std::string& text, Diagnostic diagnostic, bool color = false) {
  const Sources sources("a.task", text);
  Diagnostics diagnostics;
  diagnostics.Add(std::move(diagnostic));
  return Render(sources, diagnostics, color);
}

Diagnostic Error(Span span) { return MakeDiagnostic(code::kUnexpectedToken, span, "message"); }

TEST(Render, ShowsPlaceLineCaretsNoteAndHelp) {
  Diagnostic diagnostic = Error({7, 10});
  diagnostic.note = "here";
  diagnostic.help = "write it";
  EXPECT_EQ(RenderOne("one\ntwo three\n", diagnostic),
            "error[E0101]: message\n"
            " --> a.task:2:4\n"
            "  |\n"
            "2 | two three\n"
            "  |    ^^^ here\n"
            "  |\n"
            "  = help: write it\n"
            "\n");
}

TEST(Render, AnEmptySpanHasOneCaretEvenBehindTheLine) {
  EXPECT_THAT(RenderOne("abc\n", Error({3, 3})), HasSubstr("1 | abc\n"
                                                           "  |    ^\n"));
}

TEST(Render, ASpanOverLinesIsMarkedInTheFirst) {
  EXPECT_EQ(RenderOne("ab(\ncd)\n", Error({2, 6})),
            "error[E0101]: message\n"
            " --> a.task:1:3\n"
            "  |\n"
            "1 | ab(\n"
            "  |   ^\n"
            "\n");
}

TEST(Render, LabelsStandInTheOrderOfTheirLines) {
  Diagnostic diagnostic = Error({15, 16});
  diagnostic.labels = {{{0, 1}, "first"}, {{18, 19}, "same line"}};
  EXPECT_EQ(RenderOne("a\nb\nc\nd\ne\nf\ng\nh 1 2 3\n", diagnostic),
            "error[E0101]: message\n"
            " --> a.task:8:2\n"
            "  |\n"
            "1 | a\n"
            "  | - first\n"
            "...\n"
            "8 | h 1 2 3\n"
            "  |  ^\n"
            "  |     - same line\n"
            "\n");
}

TEST(Render, ASingleLineBetweenIsShown) {
  Diagnostic diagnostic = Error({4, 5});
  diagnostic.labels = {{{0, 1}, "opened here"}};
  EXPECT_EQ(RenderOne("a\nb\nc\n", diagnostic),
            "error[E0101]: message\n"
            " --> a.task:3:1\n"
            "  |\n"
            "1 | a\n"
            "  | - opened here\n"
            "2 | b\n"
            "3 | c\n"
            "  | ^\n"
            "\n");
}

TEST(Render, EachPlaceShowsItsOwnFile) {
  Sources sources("a.task", "one\ntwo\n");
  sources.Add("base.task", "1\n2\n3\n4\n5\n6\n7\n8\n9\nten ten\n");
  Diagnostic diagnostic = Error({31, 34});
  diagnostic.note = "here";
  diagnostic.labels = {{{4, 7}, "the second"}, {{27, 30}, "and there"}, {{0, 3}, "the first"}};
  diagnostic.help = "write it";
  Diagnostics diagnostics;
  diagnostics.Add(diagnostic);
  EXPECT_EQ(Render(sources, diagnostics, false),
            "error[E0101]: message\n"
            "  --> base.task:10:5\n"
            "   |\n"
            "10 | ten ten\n"
            "   |     ^^^ here\n"
            "   | --- and there\n"
            "  ::: a.task:2:1\n"
            "   |\n"
            " 1 | one\n"
            "   | --- the first\n"
            " 2 | two\n"
            "   | --- the second\n"
            "   |\n"
            "   = help: write it\n"
            "\n");
}

TEST(Render, TheGutterFitsTheLargestLineNumber) {
  std::string text;
  for (int i = 0; i < 9; ++i) text += "x\n";
  Diagnostic diagnostic = Error({18, 19});
  diagnostic.labels = {{{0, 1}, "first"}};
  EXPECT_EQ(RenderOne(text + "y\n", diagnostic),
            "error[E0101]: message\n"
            "  --> a.task:10:1\n"
            "   |\n"
            " 1 | x\n"
            "   | - first\n"
            "...\n"
            "10 | y\n"
            "   | ^\n"
            "\n");
}

TEST(Render, TabsReachToTheNextMultipleOfFour) {
  EXPECT_THAT(RenderOne("\tab\tc\n", Error({4, 5})), HasSubstr("1 |     ab  c\n"
                                                               "  |         ^\n"));
}

TEST(Render, CaretsStandUnderWideAndCombiningCharacters) {
  // Two columns wide, then an accent on the e, then the marked x.
  EXPECT_THAT(RenderOne("\u6f22e\u0301x\n", Error({6, 7})), HasSubstr("\n  |    ^\n"));
}

TEST(Render, DisturbingCharactersAndBadBytesAreReplaced) {
  const std::string text = RenderOne("a\x1b[31m\u202e\xff z\n", Error({11, 12}));
  EXPECT_THAT(text, HasSubstr("1 | a\uFFFD[31m\uFFFD\uFFFD z\n"
                              "  |          ^\n"));
}

TEST(Render, CarriageReturnsAreNotShown) {
  EXPECT_THAT(RenderOne("ab\r\ncd\r\n", Error({2, 2})), HasSubstr("1 | ab\n  |   ^\n"));
}

TEST(Render, OfALongLineThePartAroundTheSpanIsShown) {
  const std::string line = std::string(500, 'a') + "XYZ" + std::string(500, 'b');
  const std::string text = RenderOne(line, Error({500, 503}));
  EXPECT_THAT(text,
              HasSubstr("..." + std::string(60, 'a') + "XYZ" + std::string(77, 'b') + "...\n"));
  EXPECT_THAT(text, HasSubstr("\n  | " + std::string(63, ' ') + "^^^\n"));
}

TEST(Render, ASpanThatLeavesTheShownPartIsCut) {
  const std::string line = std::string(1000, 'a');
  const std::string text = RenderOne(line, Error({10, 900}));
  EXPECT_THAT(text, HasSubstr("\n  | " + std::string(10, ' ') + std::string(130, '^') + "\n"));
}

TEST(Render, ColorsOnlyWhenAsked) {
  EXPECT_THAT(RenderOne("abc", Error({0, 1})), Not(HasSubstr("\033")));
  const std::string text = RenderOne("abc", Error({0, 1}), true);
  EXPECT_THAT(text, HasSubstr("\033[1;31merror[E0101]\033[0m"));
  EXPECT_THAT(text, HasSubstr("\033[1;31m^\033[0m"));
}

TEST(Render, WarningsSaySo) {
  Diagnostic diagnostic = Error({0, 1});
  diagnostic.severity = Severity::kWarning;
  diagnostic.code = "W0701";
  EXPECT_THAT(RenderOne("abc", diagnostic), testing::StartsWith("warning[W0701]: message\n"));
}

TEST(Render, HelpOverSeveralLinesIsIndented) {
  Diagnostic diagnostic = Error({0, 1});
  diagnostic.help = "one\ntwo";
  EXPECT_THAT(RenderOne("abc", diagnostic), HasSubstr("  = help: one\n          two\n"));
}

TEST(Render, NothingIsSaidAboutNothing) {
  EXPECT_EQ(Render(Sources("a.task", "x"), Diagnostics(), true), "");
}

}  // namespace
}  // namespace compiler
