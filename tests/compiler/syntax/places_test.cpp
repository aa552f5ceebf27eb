// A file behind others of the same task: its places count on from theirs, and nothing else differs.
#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <string>

#include "compiler/syntax/parse.h"
#include "tests/compiler/syntax/syntax_text.h"
#include "tests/golden.h"

namespace compiler {
namespace {

const std::filesystem::path kMessages = SOURCE_DIR "/tests/compiler/syntax/messages";
constexpr uint32_t kOffset = 8;  // behind "task a\n"

// A text as the only file of a task, and as its second.
struct Twice {
  explicit Twice(const std::string& text) : first("b.task", text), second("a.task", "task a\n") {
    first_tree = Parse(first.main(), first_diagnostics);
    second_tree = Parse(second.Add("b.task", text), second_diagnostics);
  }

  Sources first;
  Sources second;
  Diagnostics first_diagnostics;
  Diagnostics second_diagnostics;
  std::optional<SyntaxTree> first_tree;
  std::optional<SyntaxTree> second_tree;
};

TEST(Places, OfErrorsCountOnFromTheFilesBefore) {
  for (const auto& path : golden::FilesIn(kMessages, "fail_", ".task")) {
    const Twice twice(golden::ReadInput(path));
    EXPECT_EQ(Render(twice.first, twice.first_diagnostics, false),
              Render(twice.second, twice.second_diagnostics, false))
        << path;
    for (const Diagnostic& diagnostic : twice.second_diagnostics.list())
      EXPECT_GE(diagnostic.span.begin, kOffset) << path;
  }
}

TEST(Places, OfNodesCountOnFromTheFilesBefore) {
  const Twice twice(
      "allow W0701\n/// A doc.\ntask t for robot\n/// Its gain.\nparam gain: real [1/s] = 4 in 0 "
      ".. 20\n"
      "on end_of_action {\n  end_episode failure \"it \\\"falls\\\"\"\n}\n");
  ASSERT_TRUE(twice.second_tree);
  const SyntaxTree& first = *twice.first_tree;
  const SyntaxTree& second = *twice.second_tree;
  EXPECT_EQ(second.doc, "A doc.");
  EXPECT_EQ(second.task->text, "t");
  EXPECT_EQ(second.task->span.begin, first.task->span.begin + kOffset);
  const auto& param = std::get<ParamDeclaration>(second.declarations[0].node);
  EXPECT_EQ(param.doc, "Its gain.");
  EXPECT_EQ(param.name.text, "gain");
  EXPECT_EQ(twice.second.FileOf(param.name.span).TextOf(param.name.span), "gain");
  EXPECT_EQ(twice.second.LineOf(param.initial.span), 5u);
  const SourceFile& file = twice.second.files().back();
  EXPECT_EQ(second.allowances[0].covers, (Span{file.first_offset(), file.end_offset()}));
  const auto& event = std::get<EventDeclaration>(second.declarations[1].node);
  const auto& end = std::get<EndStatement>(event.body[0].node);
  EXPECT_EQ(end.reason, "it \"falls\"");
  EXPECT_EQ(twice.second.FileOf(end.reason_span).TextOf(end.reason_span), "\"it \\\"falls\\\"\"");
}

}  // namespace
}  // namespace compiler
