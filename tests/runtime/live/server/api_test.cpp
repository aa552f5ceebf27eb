// What can be asked for, and what is said of wrong requests.
#include "runtime/live/server/api.h"

#include <set>

#include "runtime/live/control/command_table.h"
#include "tests/runtime/live/server/server_test.h"

namespace runtime {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class ApiTest : public ServerTest {};

json ExampleOf(ArgumentType type) {
  switch (type) {
    case ArgumentType::kText:
    case ArgumentType::kTaskFile:
      return "task";
    case ArgumentType::kWhole:
      return 3;
    case ArgumentType::kNumber:
      return 0.5;
    case ArgumentType::kFlag:
      return true;
    case ArgumentType::kValue:
      return "20 s";
    case ArgumentType::kObject:
      return {{"temperature", 2}};
  }
  return nullptr;
}

// With all arguments.
json ArgumentsOf(const CommandSpec& command) {
  json arguments = json::object();
  for (const ArgumentSpec& argument : command.arguments) {
    arguments[argument.name] = ExampleOf(argument.type);
  }
  return arguments;
}

// Commands that the fake handler replies to at once, with what it was asked.
bool IsEchoed(const CommandSpec& command) {
  return std::string_view(command.name) != "save" && std::string_view(command.name) != "unload";
}

TEST_F(ApiTest, EveryCommandGoesThroughTheSocket) {
  Start();
  for (const CommandSpec& command : Commands()) {
    if (!IsEchoed(command)) continue;
    const json arguments = ArgumentsOf(command);
    const Reply reply = Ask(folder(), {command.name, arguments});
    ASSERT_TRUE(reply.ok) << command.name << ": " << reply.error;
    EXPECT_EQ(reply.value["command"], command.name);
    EXPECT_EQ(reply.value["arguments"], arguments);
  }
}

TEST_F(ApiTest, EveryCommandGoesThroughTheLoopback) {
  Start();
  for (const CommandSpec& command : Commands()) {
    if (!IsEchoed(command)) continue;
    const json arguments = ArgumentsOf(command);
    const RawResponse response =
        ResponseTo("POST", std::string("/api/") + command.name, Credentials(), arguments.dump());
    ASSERT_EQ(response.status, 200) << command.name << ": " << response.body;
    const json answer = json::parse(response.body);
    EXPECT_EQ(answer["ok"], true);
    EXPECT_EQ(answer["value"]["command"], command.name);
    EXPECT_EQ(answer["value"]["arguments"], arguments);
  }
}

TEST_F(ApiTest, WhatOnlyLooksTakesGetAsWell) {
  Start();
  for (const CommandSpec& command : Commands()) {
    if (!IsEchoed(command)) continue;
    std::string target = std::string("/api/") + command.name;
    for (const ArgumentSpec& argument : command.arguments) {
      target += (target.find('?') == std::string::npos ? "?" : "&") + std::string(argument.name) +
                "=a%2Eb+c";
    }
    const RawResponse response = ResponseTo("GET", target, Credentials());
    ASSERT_EQ(response.status, command.changes() ? 405 : 200) << command.name;
    if (command.changes()) continue;
    const json answer = json::parse(response.body);
    for (const auto& [name, value] : answer["value"]["arguments"].items()) {
      EXPECT_EQ(value, "a.b c") << name;
    }
  }
}

TEST_F(ApiTest, ARequestWithoutABodyHasNoArguments) {
  Start();
  const RawResponse response = ResponseTo("POST", "/api/pause", Credentials());
  EXPECT_EQ(response.status, 200);
  EXPECT_EQ(json::parse(response.body)["value"]["arguments"], json::object());
}

TEST_F(ApiTest, ARefusalComesWithAllItsLines) {
  Start();
  const Reply reply = Ask(folder(), {"unload", {{"name", "shadow"}}});
  EXPECT_FALSE(reply.ok);
  EXPECT_EQ(reply.error, "there is no task module `shadow`\nthere is `task`");
  EXPECT_EQ(ResponseTo("POST", "/api/unload", Credentials(), R"({"name": "shadow"})").status, 422);
}

TEST_F(ApiTest, WrongRequestsAreExplained) {
  Start();
  struct Case {
    const char* method;
    const char* target;
    const char* body;
    int status;
    const char* error;
  };
  const std::string deep(20, '[');
  const Case cases[] = {
      {"POST", "/api/swop", "", 404, "there is no command `swop`: did you mean `swap`?"},
      {"POST", "/apo/swap", "", 404, "there is nothing at `/apo/swap`"},
      {"POST", "/", "", 405, "`/` takes GET"},
      {"POST", "/api/events", "", 405, "`/api/events` takes GET"},
      {"GET", "/api/events", "", 426, "comes over a WebSocket"},
      {"GET", "/api/pause", "", 405, "`pause` takes POST"},
      {"DELETE", "/api/list", "", 405, "`list` takes POST or GET"},
      {"POST", "/api/pause", "{", 400, "the arguments are not JSON: "},
      {"POST", "/api/pause", "{\"a\": \"\xff\"}", 400, "the arguments are not JSON: "},
      {"POST", "/api/pause", "[]", 400, "the arguments of `pause` must be a JSON object"},
      {"POST", "/api/pause", deep.c_str(), 400, "the JSON is nested too deeply"},
      {"POST", "/api/swap", R"({"name": "task"})", 400, "`swap` needs the argument `file`"},
      {"POST", "/api/step", R"({"count": "3"})", 400, "`count` of `step` must be an integer"},
      {"POST", "/api/step", R"({"cuont": 3})", 400, "did you mean `count`?"},
      {"GET", "/api/get?name", "", 400, "write `name=VALUE` in the address"},
      {"GET", "/api/get?name=%4", "", 400, "two hexadecimal digits"},
      {"GET", "/api/get?nome=task", "", 400, "`get` needs the argument `name`"},
  };
  for (const Case& each : cases) {
    const RawResponse response = ResponseTo(each.method, each.target, Credentials(), each.body);
    ASSERT_EQ(response.status, each.status)
        << each.method << " " << each.target << " " << each.body;
    EXPECT_THAT(ErrorIn(response), HasSubstr(each.error));
  }
  EXPECT_EQ(handler_.count(), 0);
}

TEST_F(ApiTest, ThePageIsMadeWhenItIsAskedFor) {
  Start();
  const RawResponse response = ResponseTo("GET", "/", Credentials());
  EXPECT_EQ(response.status, 200);
  EXPECT_THAT(response.body, HasSubstr("<html>live"));
  EXPECT_THAT(response.header, HasSubstr("Content-Type: text/html"));
  EXPECT_EQ(ResponseTo("GET", "/report", Credentials()).body, "<html>a report</html>");
  EXPECT_EQ(ResponseTo("GET", "/report?run=+of+many%2Fseed1", Credentials()).body,
            "<html>a report of many/seed1</html>");
  EXPECT_EQ(json::parse(ResponseTo("GET", "/api/record", Credentials()).body),
            json::parse(R"({"ok": true, "value": {"a": 1}})"));
}

// Another one each time, and it is all that the page allows to run.
TEST_F(ApiTest, TheLivePageRunsNoScriptButItsOwn) {
  Start();
  std::set<std::string> nonces;
  for (int i = 0; i < 2; ++i) {
    const RawResponse response = ResponseTo("GET", "/", Credentials());
    const size_t begin = response.body.find("nonce ") + 6;
    const std::string nonce = response.body.substr(begin, response.body.find('<', begin) - begin);
    EXPECT_THAT(response.header, HasSubstr("script-src 'nonce-" + nonce + "'"));
    EXPECT_THAT(response.header, HasSubstr("default-src 'none'"));
    EXPECT_THAT(response.header, Not(HasSubstr("unsafe")));
    nonces.insert(nonce);
  }
  EXPECT_EQ(nonces.size(), 2u);
}

TEST_F(ApiTest, APageThatCannotBeMadeSaysWhy) {
  const Server server({.folder = folder()}, handler_,
                      [](Page, const std::string&, const std::string&) -> std::string {
                        throw UserError("no episode yet");
                      });
  RawClient client = OnSocket();
  client.Send(RequestText("GET", "/", "Host: x\r\n"));
  const RawResponse response = client.Receive();
  EXPECT_EQ(response.status, 500);
  EXPECT_EQ(ErrorIn(response), "no episode yet");
}

}  // namespace
}  // namespace runtime
