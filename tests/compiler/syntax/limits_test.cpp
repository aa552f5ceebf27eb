#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "compiler/source/source_file.h"
#include "compiler/syntax/parse.h"
#include "tests/compiler/syntax/syntax_text.h"

namespace compiler {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

// `begin`, then `text` so many times.
std::string Repeat(const std::string& text, size_t times, std::string begin = "") {
  for (size_t i = 0; i < times; ++i) begin += text;
  return begin;
}

std::string Metric(const std::string& value) { return "task t\nmetric d = " + value + "\n"; }

TEST(Limits, BracketsMayBeNestedAsDeepAsPromised) {
  const std::string text = Repeat("(", kMaxNesting) + "1" + Repeat(")", kMaxNesting);
  EXPECT_EQ(ParseTask(Metric(text)).declarations.size(), 1u);
  EXPECT_THAT(Errors(Metric("(" + text + ")")), StartsWith("E0117 2:212 "));
}

TEST(Limits, SignsCountAsNesting) {
  const std::string text = Repeat("- ", kMaxNesting - 1) + "1";
  EXPECT_EQ(ParseTask(Metric(text)).declarations.size(), 1u);
  EXPECT_THAT(Errors(Metric("- - " + text)), StartsWith("E0117 "));
}

TEST(Limits, SignsInFrontOfBracketsAddUp) {
  const std::string text = Repeat("- - (", 100) + "1" + Repeat(")", 100);
  EXPECT_THAT(Errors(Metric(text)), StartsWith("E0117 "));
}

TEST(Limits, BlocksMayBeNestedAsDeepAsPromised) {
  const std::string text =
      Repeat("if a { ", kMaxNesting - 1) + "n = 1" + Repeat(" }", kMaxNesting - 1);
  EXPECT_EQ(ParseBlock(text).size(), 1u);
  EXPECT_THAT(Errors("task t\non end_of_action { if a { " + text + " } }\n"), HasSubstr("E0117 "));
}

TEST(Limits, LoopsAndOnceCountAsNesting) {
  const std::string text =
      Repeat("for i in {0} { once per run if a { ", 99) + "n = 1" + Repeat(" } }", 99);
  EXPECT_EQ(ParseBlock(text).size(), 1u);
  EXPECT_THAT(Errors("task t\non end_of_action { for i in 0..1 { if a { " + text + " } } }\n"),
              HasSubstr("E0117 "));
}

TEST(Limits, IndexSetsAreLimited) {
  const std::string set = Repeat(" - a", kMaxNesting, "links");
  EXPECT_THAT(Errors("task t\non end_of_action { for l in " + set + " { } }\n"),
              StartsWith("E0117 2:29 "));
  EXPECT_THAT(Errors("task t\non end_of_action { n[" + set + "] = 1 }\n"),
              StartsWith("E0117 2:22 "));
  EXPECT_THAT(Errors("task t\ntest \"a\" { given n[" + set + "] = 1 }\n"),
              StartsWith("E0117 2:20 "));
}

TEST(Limits, ChainsOfOperatorsAreLimited) {
  EXPECT_EQ(ParseTask(Metric(Repeat(" + 1", kMaxNesting - 1, "1"))).declarations.size(), 1u);
  EXPECT_THAT(Errors(Metric(Repeat(" + 1", kMaxNesting, "1"))), StartsWith("E0117 2:12 "));
  EXPECT_THAT(Errors(Metric(Repeat(".x", 5000, "a"))), StartsWith("E0117 2:12 "));
  EXPECT_THAT(Errors(Metric(Repeat("[1]", 5000, "a"))), StartsWith("E0117 2:12 "));
}

TEST(Limits, AnUnclosedAvalancheIsRefusedAtOnce) {
  EXPECT_THAT(Errors(Metric(Repeat("(", 20'000))), StartsWith("E0117 "));
  EXPECT_THAT(Errors(Metric(Repeat("[", 20'000))), StartsWith("E0117 "));
  EXPECT_THAT(Errors(Metric(Repeat("not ", 20'000))), StartsWith("E0117 "));
  EXPECT_THAT(Errors("task t\n" + Repeat("{", 20'000)), StartsWith("E0117 "));
}

TEST(Limits, SomethingElseThanATaskHasAHundredErrors) {
  const std::string errors = Errors(Metric(Repeat("@", 20'000)));
  EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 100);
}

TEST(Limits, WideIsNotDeep) {
  EXPECT_EQ(ParseTask(Metric(Repeat(", 1", 2000, "max(1") + ")")).declarations.size(), 1u);
  EXPECT_EQ(ParseBlock(Repeat("\nelse if b { }", 2000, "if a { }")).size(), 1u);
  EXPECT_EQ(ParseBlock(Repeat("n = 1\n", 2000)).size(), 2000u);
  EXPECT_EQ(ParseBlock(Repeat(", 1", 2000, "for i in 0") + " { }").size(), 1u);
}

TEST(Limits, AFileMayBeAsLargeAsPromised) {
  const std::string header = "task t\n//";
  const std::string text = header + std::string(SourceFile::kMaxSize - header.size(), 'x');
  EXPECT_EQ(ParseTask(text).task->text, "t");
  EXPECT_EQ(Errors(text + "x"), "E0116 1:1 the file is larger than 100000 bytes\n");
}

}  // namespace
}  // namespace compiler
