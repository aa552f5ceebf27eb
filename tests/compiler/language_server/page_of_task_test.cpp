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
  const Json lines = BlockOf(page, "formulas")["lines"];
  EXPECT_FALSE(lines[0].contains("term")) << "the sum of all terms";
  const Json& fall = lines[2];
  EXPECT_EQ(fall["term"], "fall");
  EXPECT_EQ(fall["left"], "r_{\\text{fall}}");
  EXPECT_EQ(fall["sign"], "=");
  EXPECT_THAT(fall["right"].get<std::string>(),
              HasSubstr("\\begin{cases} -\\mathrm{fall\\_penalty}"));
  EXPECT_EQ(fall["reads"][0], "fall_penalty");
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
