// An editor that talks to a language server of its own, and what it has open.
#pragma once

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "compiler/language_server/language_server.h"
#include "compiler/language_server/uri.h"
#include "tests/compiler/language_server/marked_text.h"
#include "tests/compiler/temporary_folder.h"

namespace compiler {

using protocol::Json;

inline constexpr const char* kTask = R"(/// Move forward.
task crawling for humanoid

start standing

/// What a fall costs.
param fall_penalty: real = 4 in 0 .. 20

memory fallen: bool = false per action

on end_of_time_step {
  let speed = norm(base.velocity.xy)
  reward rate forward = speed / 1 m
  if not fallen and any(contact[body, head]) {
    fallen = true
    reward fall = -fall_penalty
  }
  if time > 20 s { truncate_episode "time is up" }
}
)";

// An editor with a folder of its own.
class Editor {
 public:
  explicit Editor(const Json& capabilities = Json::object())
      : server_({.robots = SOURCE_DIR "/plugins", .diagnostics_page = "/page.md"}) {
    const Json folder{{"uri", UriOfPath(folder_.path())}, {"name", "tasks"}};
    greeting = Ask("initialize",
                   {{"capabilities", capabilities}, {"workspaceFolders", Json::array({folder})}});
    Tell("initialized", Json::object());
  }

  // The answer's result, or its error.
  Json Ask(const std::string& method, const Json& params) {
    const Json request{{"jsonrpc", "2.0"}, {"id", 7}, {"method", method}, {"params", params}};
    const std::vector<Json> answers = server_.Receive(request.dump());
    EXPECT_EQ(answers.size(), 1u);
    EXPECT_EQ(answers.at(0)["id"], 7);
    return answers[0].contains("result") ? answers[0]["result"] : answers[0].at("error");
  }

  // What the server then says by itself.
  std::vector<Json> Tell(const std::string& method, const Json& params) {
    const Json notification{{"jsonrpc", "2.0"}, {"method", method}, {"params", params}};
    EXPECT_THAT(server_.Receive(notification.dump()), testing::IsEmpty());
    return server_.Report();
  }

  std::string UriOf(const std::string& name) const { return UriOfPath(folder_.path() / name); }

  std::vector<Json> Open(const std::string& name, const std::string& text) {
    return Tell("textDocument/didOpen",
                {{"textDocument",
                  {{"uri", UriOf(name)}, {"languageId", "task"}, {"version", 1}, {"text", text}}}});
  }
  void Write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name) << text;
  }

  // Asks about the place of the cursor in a text that is opened for it.
  Json AskAt(const std::string& method, const std::string& marked, Json more = Json::object()) {
    const MarkedText at(marked);
    Open("asked.task", at.text);
    return AskIn("asked.task", method, at, std::move(more));
  }
  Json AskIn(const std::string& name, const std::string& method, const MarkedText& at,
             Json more = Json::object()) {
    const TextPositions positions(at.text, PositionEncoding::kUtf16);
    more["textDocument"] = {{"uri", UriOf(name)}};
    more["position"] = protocol::ToJson(positions.PositionOf(at.offset));
    return Ask("textDocument/" + method, more);
  }

  std::string HoverAt(const std::string& marked) {
    const Json hover = AskAt("hover", marked);
    return hover.is_null() ? "" : hover["contents"]["value"].get<std::string>();
  }

  std::vector<std::string> CompleteAt(const std::string& marked) {
    std::vector<std::string> labels;
    const Json list = AskAt("completion", marked);
    for (const Json& item : list["items"]) labels.push_back(item["label"]);
    return labels;
  }

  LanguageServer& server() { return server_; }

  Json greeting;

 private:
  TemporaryFolder folder_;
  LanguageServer server_;
};

// The task with its first `from` replaced.
inline std::string TaskWith(const std::string& from, const std::string& to) {
  std::string text = kTask;
  const size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return text.replace(place, from.size(), to);
}

// "2:4-2:9"
inline std::string Text(const Json& range) {
  return fmt::format("{}:{}-{}:{}", range["start"]["line"].get<int>(),
                     range["start"]["character"].get<int>(), range["end"]["line"].get<int>(),
                     range["end"]["character"].get<int>());
}

inline std::vector<std::string> Ranges(const Json& places) {
  std::vector<std::string> ranges;
  for (const Json& place : places) ranges.push_back(Text(place["range"]));
  return ranges;
}

}  // namespace compiler
