// The lets of a task that is being written, with the numbers of a run.
#include <gmock/gmock.h>

#include "tests/compiler/language_server/editor.h"

namespace compiler {
namespace {

using testing::HasSubstr;

Json LetsIn(Editor& editor, const std::string& text, const Json& known) {
  editor.Open("lean.task", text);
  return editor.Ask("task/lets",
                    {{"textDocument", {{"uri", editor.UriOf("lean.task")}}}, {"known", known}});
}

constexpr const char* kLean =
    "task lean for humanoid\n"
    "on end_of_time_step {\n"
    "  let angle = acos(base.up.z)\n"
    "  let side = 1 / base.up.x\n"
    "  reward straight = -angle / 1 rad\n"
    "  reward sideways = side\n"
    "}\n";

TEST(WorthOfLets, IsToldByNames) {
  Editor editor;
  EXPECT_EQ(LetsIn(editor, kLean, {{"base.up", {0, 0, 1}}}),
            Json::parse(R"([{"name": "angle", "type": "real", "unit": "rad", "numbers": [0.0]}])"))
      << "a number that is not finite is none";
  EXPECT_EQ(LetsIn(editor, kLean, {{"base.up", {0.5, 0, 1}}}).size(), 2);
}

TEST(WorthOfLets, IsNullWhereTheTextHasErrors) {
  Editor editor;
  EXPECT_EQ(
      LetsIn(editor, "task lean for humanoid\non end_of_time_step { let a = }\n", Json::object()),
      nullptr);
}

TEST(WorthOfLets, RefusesWhatIsNoObjectOfNumbers) {
  Editor editor;
  editor.Open("lean.task", kLean);
  const Json document = {{"uri", editor.UriOf("lean.task")}};
  for (const Json& known : {Json(1), Json({{"base.up", "x"}}), Json({{"base.up", 1}})}) {
    const Json answer = editor.Ask("task/lets", {{"textDocument", document}, {"known", known}});
    EXPECT_EQ(answer["code"], protocol::kInvalidParams) << known;
  }
}

}  // namespace
}  // namespace compiler
