// Edits that an editor is offered for what is wrong.
#include "tests/compiler/language_server/editor.h"

namespace compiler {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// What is offered at the cursor.
Json ActionsAt(Editor& editor, const std::string& marked, Json context = Json::object()) {
  const MarkedText at(marked);
  editor.Open("asked.task", at.text);
  const TextPositions positions(at.text, PositionEncoding::kUtf16);
  const Json place = protocol::ToJson(positions.PositionOf(at.offset));
  context["diagnostics"] = Json::array();
  return editor.Ask("textDocument/codeAction",
                    {{"textDocument", {{"uri", editor.UriOf("asked.task")}}},
                     {"range", {{"start", place}, {"end", place}}},
                     {"context", context}});
}

TEST(CodeActions, AreAnnounced) {
  EXPECT_EQ(Editor().greeting["capabilities"]["codeActionProvider"]["codeActionKinds"],
            Json({"quickfix"}));
}

TEST(CodeActions, AreTheFixesOfMessages) {
  Editor editor;
  const Json actions = ActionsAt(editor, "task a for humanoid\nmetric far = bas.vel|ocity.x\n");
  ASSERT_EQ(actions.size(), 1u);
  EXPECT_EQ(actions[0]["title"], "Replace by `base.velocity`");
  EXPECT_EQ(actions[0]["kind"], "quickfix");
  EXPECT_EQ(actions[0]["isPreferred"], true);
  EXPECT_EQ(actions[0]["diagnostics"][0]["code"], "E0202");
  const Json edit = actions[0]["edit"]["changes"][editor.UriOf("asked.task")].at(0);
  EXPECT_EQ(Text(edit["range"]), "1:13-1:25");
  EXPECT_EQ(edit["newText"], "base.velocity");
}

TEST(CodeActions, OfferEachAlternative) {
  Editor editor;
  const Json actions = ActionsAt(editor, "task a\nmetric far = sin(|30)\n");
  ASSERT_EQ(actions.size(), 2u);
  EXPECT_EQ(actions[0]["title"], "Replace by `30 deg`");
  EXPECT_EQ(actions[1]["title"], "Replace by `30 rad`");
  EXPECT_EQ(actions[0]["isPreferred"], false);
}

TEST(CodeActions, SayWhatTheyRemoveAndInsert) {
  Editor editor;
  EXPECT_EQ(ActionsAt(editor, "task a\nmetric far = 1 + |+2\n").at(0)["title"], "Remove `+`");
  EXPECT_EQ(ActionsAt(editor, "task a\nmetric far = sin(exp(1)|)\n").at(0)["title"],
            "Insert ` * 1 rad`");
}

TEST(CodeActions, AreThereOnlyWhereTheMistakeIs) {
  Editor editor;
  EXPECT_EQ(ActionsAt(editor, "task| a\nmetric far = sin(30)\n"), Json::array());
  EXPECT_EQ(ActionsAt(editor, "task a\nmetric far = completely_unknown|\n"), Json::array());
}

TEST(CodeActions, AreOnlyOfTheKindsThatAreWanted) {
  Editor editor;
  const std::string text = "task a\nmetric far = sin(|30)\n";
  EXPECT_EQ(ActionsAt(editor, text, {{"only", {"refactor"}}}), Json::array());
  EXPECT_EQ(ActionsAt(editor, text, {{"only", {"refactor", "quickfix"}}}).size(), 2u);
}

// The message that shows a mistake may still be under way.
TEST(CodeActions, AreThoseOfThePresentText) {
  Editor editor;
  editor.Open("a.task", "task a\nmetric far = sin(30)\n");
  const Json document{{"uri", editor.UriOf("a.task")}, {"version", 2}};
  const Json change{{"jsonrpc", "2.0"},
                    {"method", "textDocument/didChange"},
                    {"params",
                     {{"textDocument", document},
                      {"contentChanges", {{{"text", "task a\n\nmetric far = sin(40)\n"}}}}}}};
  editor.server().Receive(change.dump());
  const Json whole{{"start", {{"line", 0}, {"character", 0}}},
                   {"end", {{"line", 9}, {"character", 0}}}};
  const Json actions =
      editor.Ask("textDocument/codeAction", {{"textDocument", document},
                                             {"range", whole},
                                             {"context", {{"diagnostics", Json::array()}}}});
  EXPECT_EQ(actions.at(0)["title"], "Replace by `40 deg`");
}

}  // namespace
}  // namespace compiler
