// A session with an editor, message by message.
#include "compiler/language_server/language_server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "compiler/language_server/message_stream.h"
#include "tests/compiler/language_server/editor.h"

namespace compiler {
namespace {

using protocol::Json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

TEST(LanguageServer, TellsWhatItCan) {
  const Editor editor;
  EXPECT_EQ(editor.greeting["capabilities"]["positionEncoding"], "utf-16");
  EXPECT_EQ(editor.greeting["capabilities"]["hoverProvider"], true);
  EXPECT_EQ(editor.greeting["serverInfo"]["name"], "taskc");
  const Json utf8 = {{"general", {{"positionEncodings", {"utf-32", "utf-8"}}}}};
  const Editor modern(utf8);
  EXPECT_EQ(modern.greeting["capabilities"]["positionEncoding"], "utf-8");
}

TEST(LanguageServer, AnswersWrongRequestsWithErrors) {
  Editor editor;
  EXPECT_EQ(editor.Ask("textDocument/unheardOf", {})["code"], protocol::kMethodNotFound);
  EXPECT_EQ(editor.Ask("textDocument/hover", {})["code"], protocol::kInvalidParams);
  EXPECT_EQ(editor.Ask("textDocument/hover", Json::array())["code"], protocol::kInvalidParams);
  EXPECT_EQ(editor.Ask("initialize", Json::object())["code"], protocol::kInvalidRequest);
  EXPECT_EQ(editor.server().Receive("{").at(0)["error"]["code"], protocol::kParseError);
  EXPECT_EQ(editor.server().Receive("17").at(0)["error"]["code"], protocol::kInvalidRequest);
  EXPECT_EQ(editor.server().Receive(R"({"id": 1, "method": 2})").at(0)["error"]["code"],
            protocol::kInvalidRequest);
  EXPECT_THAT(editor.server().Receive(R"({"id": 1, "result": null})"), IsEmpty());
  EXPECT_THAT(editor.Tell("textDocument/didChange", {}), IsEmpty());
  EXPECT_THAT(editor.Tell("$/cancelRequest", {{"id", 1}}), IsEmpty());
}

TEST(LanguageServer, WantsToBeInitializedFirst) {
  LanguageServer server({});
  EXPECT_EQ(server.Receive(R"({"id": 1, "method": "shutdown"})").at(0)["error"]["code"],
            protocol::kNotInitialized);
}

TEST(LanguageServer, LeavesWhenItIsTold) {
  Editor editor;
  EXPECT_TRUE(editor.Ask("shutdown", nullptr).is_null());
  EXPECT_EQ(editor.Ask("textDocument/hover", {})["code"], protocol::kInvalidRequest);
  EXPECT_FALSE(editor.server().has_exited());
  editor.Tell("exit", nullptr);
  EXPECT_TRUE(editor.server().has_exited());
  EXPECT_EQ(editor.server().exit_status(), 0);
}

TEST(LanguageServer, ServesAStream) {
  LanguageServer server({});
  std::stringstream in;
  std::ostringstream out;
  WriteMessage(in, R"({"id": 1, "method": "initialize", "params": {"capabilities": {}}})");
  WriteMessage(in, R"({"id": 2, "method": "shutdown"})");
  WriteMessage(in, R"({"method": "exit"})");
  EXPECT_EQ(Serve(server, in, out), 0);
  EXPECT_THAT(out.str(), AllOf(StartsWith("Content-Length: "), HasSubstr("positionEncoding")));
  LanguageServer left({});
  std::istringstream nothing;
  EXPECT_EQ(Serve(left, nothing, out), 1) << "the editor has crashed";
}

TEST(Formatting, GivesTheWholeText) {
  Editor editor;
  editor.Open("a.task", "task  t\n");
  const Json params{{"textDocument", {{"uri", editor.UriOf("a.task")}}},
                    {"options", {{"tabSize", 4}, {"insertSpaces", true}}}};
  const Json edits = editor.Ask("textDocument/formatting", params);
  ASSERT_EQ(edits.size(), 1u);
  EXPECT_EQ(edits[0]["newText"], "task t\n");
  EXPECT_EQ(Text(edits[0]["range"]), "0:0-1:0");
  editor.Open("a.task", "task t\n");
  EXPECT_EQ(editor.Ask("textDocument/formatting", params), Json::array());
  editor.Open("a.task", "task  t (\n");
  EXPECT_EQ(editor.Ask("textDocument/formatting", params), Json::array());
}

TEST(Signatures, FollowTheArguments) {
  Editor editor;
  const Json help = editor.AskAt("signatureHelp", TaskWith("norm(base", "clamp(1, |base"));
  EXPECT_EQ(help["signatures"].at(0)["label"], "clamp(x, low, high)");
  EXPECT_EQ(help["signatures"].at(0)["parameters"].at(1)["label"], "low");
  EXPECT_EQ(help["activeParameter"], 1);
  EXPECT_TRUE(editor.AskAt("signatureHelp", TaskWith("start", "sta|rt")).is_null());
}

TEST(Signatures, OfTablesSayHowToRepeatThem) {
  Editor editor;
  editor.Write("curve.csv", "x, y\n0, 1\n2, 3\n");
  const Json help = editor.AskAt(
      "signatureHelp", "task t\ntable height: real = \"curve.csv\"\nmetric a = height(1, |)\n");
  EXPECT_EQ(help["signatures"].at(1)["label"], "height(x, loop) -> real");
  EXPECT_EQ(help["activeSignature"], 1);
}

TEST(Symbols, MakeAnOutline) {
  Editor editor;
  editor.Open("a.task", kTask);
  const Json symbols = editor.Ask("textDocument/documentSymbol",
                                  {{"textDocument", {{"uri", editor.UriOf("a.task")}}}});
  std::vector<std::string> names;
  for (const Json& symbol : symbols) names.push_back(symbol["name"]);
  EXPECT_THAT(names, ElementsAre("crawling", "fall_penalty", "fallen", "end_of_time_step"));
  std::vector<std::string> terms;
  for (const Json& symbol : symbols.back()["children"]) terms.push_back(symbol["name"]);
  EXPECT_THAT(terms, ElementsAre("forward", "fall"));
}

// Every prefix of a task, and tasks with damaged bytes: all questions have an answer.
TEST(LanguageServer, SurvivesEveryText) {
  Editor editor;
  std::mt19937 random(5);
  const std::string bytes = "{}()[]\"/ \n\r.=-+*^:,a1\xC3\xA4\xFF";
  for (int i = 0; i < 150; ++i) {
    std::string text = kTask;
    if (i % 2 == 0) text.resize(random() % text.size());
    for (int k = 0; k < 3 && !text.empty(); ++k) {
      text[random() % text.size()] = bytes[random() % bytes.size()];
    }
    editor.server().Receive(
        Json{{"method", "textDocument/didOpen"},
             {"params", {{"textDocument", {{"uri", "file:///x/a.task"}, {"text", text}}}}}}
            .dump(-1, ' ', false, Json::error_handler_t::replace));
    editor.server().Report();
    for (const char* method : {"hover", "completion", "definition", "references", "signatureHelp",
                               "documentSymbol", "prepareRename", "documentHighlight"}) {
      const Json answer =
          editor.Ask("textDocument/" + std::string(method),
                     {{"textDocument", {{"uri", "file:///x/a.task"}}},
                      {"position", {{"line", random() % 20}, {"character", random() % 30}}}});
      EXPECT_FALSE(answer.is_object() && answer.contains("code")) << method << answer << text;
    }
  }
}

}  // namespace
}  // namespace compiler
