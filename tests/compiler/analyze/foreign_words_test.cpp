// The words of other languages: whoever writes one is told what to write here.
#include "compiler/syntax/foreign_words.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "compiler/analyze/analyze.h"
#include "compiler/check/builtins.h"
#include "compiler/check/type.h"

namespace compiler {
namespace {

struct Row {
  ForeignPlace place;
  std::string word;
};

std::vector<Row> Rows() {
  using enum ForeignPlace;
  return {
#define FOREIGN(place, word, instead, help) {place, word},
#include "compiler/syntax/foreign_words.def"
#undef FOREIGN
  };
}

std::string TaskWith(const std::string& declaration, const std::string& statement) {
  return "task t for humanoid\n" + declaration + "\non end_of_time_step {\n  " + statement +
         "\n}\n";
}

// A task in which the word stands in its place.
std::string TaskOf(const Row& row) {
  switch (row.place) {
    case ForeignPlace::kStatement:
      return TaskWith("", row.word + " a 1");
    case ForeignPlace::kDeclaration:
      return TaskWith(row.word + " a 1", "");
    case ForeignPlace::kOperator:
      return TaskWith("", "let x = contact[head] " + row.word + " contact[body]");
    case ForeignPlace::kOperand:
      return TaskWith("", "let x = " + row.word);
    case ForeignPlace::kModule:
      return TaskWith("", "let x = " + row.word + ".sqrt(3)");
    case ForeignPlace::kFunction:
      return TaskWith("", "let x = " + row.word + "(3)");
    case ForeignPlace::kType:
      return TaskWith("memory x: " + row.word + " = 0", "");
    case ForeignPlace::kUnit:
      return TaskWith("", "let x = 3 " + row.word);
  }
  return "";
}

Analysis AnalyzeText(const std::string& text) {
  const auto read = [&](const std::filesystem::path&) { return text; };
  return Analyze("t.task", read, SOURCE_DIR "/plugins");
}

TEST(ForeignWords, AreAnsweredInTheirPlaces) {
  for (const Row& row : Rows()) {
    const std::string text = TaskOf(row);
    const Analysis analysis = AnalyzeText(text);
    const Help help = HelpForForeign(row.place, row.word, {});
    const std::string wanted =
        row.place == ForeignPlace::kModule ? std::string("write `sqrt`") : help.text;
    const bool is_said =
        std::ranges::any_of(analysis.diagnostics.list(),
                            [&](const Diagnostic& each) { return each.help.text == wanted; });
    EXPECT_TRUE(is_said) << text << Render(analysis.sources, analysis.diagnostics, false);
  }
}

TEST(ForeignWords, AreReplacedByWordsOfThisLanguage) {
  for (const Row& row : Rows()) {
    const ForeignWord* word = FindForeign(row.place, row.word);
    ASSERT_NE(word, nullptr) << row.word;
    if (row.place == ForeignPlace::kFunction && !word->instead.empty() && word->instead != "not") {
      EXPECT_NE(FindBuiltin(word->instead), nullptr) << word->instead;
    }
    if (row.place == ForeignPlace::kType && !word->instead.empty()) {
      EXPECT_TRUE(FindType(word->instead)) << word->instead;
    }
    if (row.place != ForeignPlace::kModule) {
      EXPECT_FALSE(word->instead.empty() && word->help.empty()) << row.word;
    }
  }
}

TEST(ForeignWords, AreNamesWhereTheTaskDeclaresThem) {
  const Analysis analysis = AnalyzeText(
      TaskWith("memory done: bool = false\nfn length(x: real) -> real = x",
               "let dt = length(3) done = true if done and dt > 2 { end_episode failure \"a\" }"));
  EXPECT_TRUE(analysis.task) << Render(analysis.sources, analysis.diagnostics, false);
}

}  // namespace
}  // namespace compiler
