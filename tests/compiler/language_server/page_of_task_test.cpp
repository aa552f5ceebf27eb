// The page of a task that is being written.
#include <gmock/gmock.h>

#include "tests/compiler/language_server/editor.h"

namespace compiler {
namespace {

using testing::HasSubstr;

Json PageIn(Editor& editor, const std::string& text) {
  editor.Open("crawling.task", text);
  return editor.Ask("task/page", {{"textDocument", {{"uri", editor.UriOf("crawling.task")}}}});
}

Json BlockOf(const Json& page, const std::string& kind) {
  for (const Json& block : page["blocks"]) {
    if (block["kind"] == kind) return block;
  }
  return nullptr;
}

TEST(PageOfTask, HasTheEquations) {
  Editor editor;
  const Json page = PageIn(editor, kTask);
  EXPECT_EQ(page["title"], "crawling");
  EXPECT_THAT(BlockOf(page, "formulas")["latex"].get<std::string>(),
              HasSubstr("r_{\\text{fall}} &= \\begin{cases} -\\mathrm{fall\\_penalty}"));
  const Json table = BlockOf(page, "table");
  EXPECT_EQ(table["header"][0], "term");
  EXPECT_EQ(table["rows"][0][0][0], Json({{"face", "code"}, {"text", "forward"}}));
  EXPECT_EQ(BlockOf(page, "heading")["level"], 2);
}

TEST(PageOfTask, HasThePhases) {
  Editor editor;
  const Json page =
      PageIn(editor,
             "task crawling for humanoid\nphase rise {\n  if base.position.z > 0.2 m {"
             " next go }\n}\nphase go {\n  reward rate far = base.velocity.x / 1 m\n}\n");
  const Json automaton = BlockOf(page, "automaton");
  EXPECT_EQ(automaton["phases"], Json({"rise", "go"}));
  EXPECT_EQ(automaton["ways"][0]["to"], "go");
}

TEST(PageOfTask, IsNotThereWhileTheTextHasErrors) {
  Editor editor;
  EXPECT_TRUE(PageIn(editor, "task crawling for humanoid\nmetric a = nothing\n").is_null());
}

}  // namespace
}  // namespace compiler
