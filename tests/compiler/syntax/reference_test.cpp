// The examples of the documentation are what it says of them, and the tasks that the project ships
// are well-formed.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "compiler/source/diagnostic_table.h"
#include "tests/compiler/syntax/syntax_text.h"
#include "tests/golden.h"

namespace compiler {
namespace {

// The blocks between the line `begin` and "```".
std::vector<std::string> Examples(const std::string& page, std::string begin = "```task") {
  begin += '\n';
  std::vector<std::string> examples;
  for (size_t i = page.find(begin); i != std::string::npos; i = page.find(begin, i)) {
    i += begin.size();
    const size_t end = page.find("```", i);
    examples.push_back(page.substr(i, end - i));
    i = end;
  }
  return examples;
}

// A whole task has a header; other examples are declarations or else statements.
std::string MakeTask(const std::string& example) {
  const std::string header = "task example for humanoid\n";
  if (example.find("task ") == 0 || example.find("\ntask ") != std::string::npos) return example;
  for (const char* word : {"start ", "sensor ", "param ", "const ", "set ", "table ", "memory ",
                           "goal ", "observe ", "phase ", "metric ", "reward potential ", "on ",
                           "override ", "fn ", "after_end ", "import ", "test ", "allow "}) {
    if (example.find(word) == 0 || example.find(std::string("\n") + word) != std::string::npos) {
      return header + example;
    }
  }
  return header + "on end_of_time_step {\n" + example + "}\n";
}

TEST(LanguageReference, ExamplesAreWellFormed) {
  const std::string page = golden::ReadFile(SOURCE_DIR "/docs/language.md");
  const auto examples = Examples(page);
  EXPECT_GT(examples.size(), 10u);
  for (const std::string& example : examples) ParseTask(MakeTask(example));
  const auto files = Examples(page, "```task of several files");
  EXPECT_GT(files.size(), 2u);
  for (const std::string& file : files) ParseTask(file);
}

// The two examples of each section: how not to write it, and how to.
TEST(DiagnosticsPage, ExamplesAreWrongAndRight) {
  const std::string page = golden::ReadFile(SOURCE_DIR "/docs/diagnostics.md");
  for (const DiagnosticKind& kind : kDiagnosticTable) {
    const size_t begin = page.find(fmt::format("\n### {}", kind.code));
    ASSERT_NE(begin, std::string::npos) << kind.code;
    const auto examples = Examples(page.substr(begin, page.find("\n##", begin + 1) - begin));
    if (examples.empty()) continue;  // the limits: too long to print
    ASSERT_EQ(examples.size(), 2u) << kind.code;
    const bool is_syntax = kind.code.starts_with("E01") || kind.code == code::kMisplacedPotential;
    const bool is_whole = kind.code == code::kMissingHeader || kind.code == code::kNotInLibrary;
    const std::string wrong = is_whole ? examples[0] : MakeTask(examples[0]);
    if (is_syntax) {
      EXPECT_THAT(Errors(wrong), testing::StartsWith(std::string(kind.code))) << wrong;
    } else {
      ParseTask(wrong);
    }
    ParseTask(MakeTask(examples[1]));
  }
}

TEST(Tasks, AreWellFormed) {
  for (const auto& path : golden::FilesIn(SOURCE_DIR "/tasks", "", ".task")) {
    const SyntaxTree tree = ParseTask(golden::ReadFile(path));
    EXPECT_EQ(tree.task->text, path.stem().string());
    EXPECT_FALSE(tree.doc.empty()) << path;
  }
}

}  // namespace
}  // namespace compiler
