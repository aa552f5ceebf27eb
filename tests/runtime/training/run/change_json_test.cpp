#include "runtime/training/run/change_json.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/runtime/training/run/error_of.h"

namespace runtime {
namespace {

constexpr int64_t kTasks = 3;  // of the run

struct Written {
  Change change;
  std::string data;  // as every version of the trainer has written it
};

// One for each kind and for what it may leave out.
const Written kWritten[] = {
    {SwapTask{"task", 2}, R"({"command":"swap","name":"task","task":2})"},
    {SwapTask{"task", 2, true}, R"({"command":"swap","forget":true,"name":"task","task":2})"},
    {LoadShadow{"new", 3}, R"({"command":"load","name":"new","task":3})"},
    {RollBackTask{"task", 1}, R"({"command":"rollback","name":"task","task":1})"},
    {PromoteTask{"new"}, R"({"command":"promote","name":"new"})"},
    {PromoteTask{"new", true}, R"({"command":"promote","forget":true,"name":"new"})"},
    {UnloadShadow{"new"}, R"({"command":"unload","name":"new"})"},
    {SetParameter{"a.b", true}, R"({"command":"set","name":"a.b","value":true})"},
    {SetParameter{"a.b", int64_t{2}}, R"({"command":"set","name":"a.b","value":2})"},
    {SetParameter{"a.b", 2.0}, R"({"command":"set","name":"a.b","value":2.0})"},
    {SetParameter{"a.b", 0.1}, R"({"command":"set","name":"a.b","value":0.1})"},
    {SetParameter{"a.b", std::string("wild \"ü\"")},
     R"({"command":"set","name":"a.b","value":"wild \"ü\""})"},
    {SetParameter{"a.b", std::vector{1.0, -0.5}},
     R"({"command":"set","name":"a.b","value":[1.0,-0.5]})"},
    {ScheduleParameter{"a.b", int64_t{2}, 0.5, 10},
     R"({"command":"set","episodes":10,"from":2,"name":"a.b","to":0.5})"},
    {HoldGoal{"task.speed", 0.5}, R"({"command":"hold","name":"task.speed","value":0.5})"},
    {HoldGoal{"task.place", std::vector{1.0, -0.5}},
     R"({"command":"hold","name":"task.place","value":[1.0,-0.5]})"},
    {ReleaseGoal{"task.speed"}, R"({"command":"release","name":"task.speed"})"},
    {ConnectPorts{"a.b", "c.d"}, R"({"command":"connect","first":"a.b","second":"c.d"})"},
    {DisconnectPorts{"a.b", "c.d"}, R"({"command":"disconnect","first":"a.b","second":"c.d"})"},
    {AddModule{"NgNet", "net", {}}, R"({"command":"module_add","name":"net","type":"NgNet"})"},
    {AddModule{"NgNet", "net", {{"file", std::string("x")}, {"width", int64_t{3}}}},
     R"({"command":"module_add","name":"net","parameters":{"file":"x","width":3},"type":"NgNet"})"},
    {RemoveModule{"net"}, R"({"command":"module_remove","name":"net"})"},
    {PutInQuarantine{.task = 2, .change = {}, .why = "loop"},
     R"({"command":"quarantine","task":2,"why":"loop"})"},
    {PutInQuarantine{.task = {}, .change = 7, .why = "loop"},
     R"({"change":7,"command":"quarantine","why":"loop"})"},
    {UnknownChange{"twist", R"({"by": [2], "command": "twist", "task": "all"})"},
     R"({"by": [2], "command": "twist", "task": "all"})"},
};

TEST(ChangeJson, EachKindIsReadAsItWasWritten) {
  std::set<size_t> kinds;
  for (const Written& each : kWritten) {
    EXPECT_EQ(ChangeData(each.change), each.data);
    const Change read = ReadChange(std::string(KindOf(each.change)), each.data, kTasks);
    EXPECT_EQ(read.index(), each.change.index()) << each.data;
    EXPECT_EQ(ChangeData(read), each.data);
    kinds.insert(read.index());
  }
  EXPECT_EQ(kinds.size(), std::variant_size_v<Change>) << "a kind without an example";
}

// What earlier versions have written besides, or a person by hand.
TEST(ChangeJson, MoreThanAKindSaysIsPassedOver) {
  const Change read = ReadChange(
      "swap",
      R"({"name": "task", "now": true, "forget": false, "command": "swap", "task": 1, "file": "a"})",
      kTasks);
  EXPECT_EQ(ChangeData(read), R"({"command":"swap","name":"task","task":1})");
}

std::string Wrong(const std::string& kind, const std::string& data) {
  return ErrorOf([&] { ReadChange(kind, data, kTasks); });
}

TEST(ChangeJson, WhatIsMissingIsNamed) {
  struct Case {
    const char* kind;
    const char* members;
    const char* missing;
  };
  for (const Case& each : {Case{"swap", R"("task": 1)", "name"},
                           {"swap", R"("name": "task")", "task"},
                           {"load", R"("name": "new")", "task"},
                           {"rollback", R"("name": "task")", "task"},
                           {"promote", R"("forget": true)", "name"},
                           {"unload", R"("task": 1)", "name"},
                           {"set", R"("value": 1)", "name"},
                           {"set", R"("name": "a.b")", "from"},
                           {"set", R"("name": "a.b", "from": 1)", "to"},
                           {"set", R"("name": "a.b", "from": 1, "to": 2)", "episodes"},
                           {"connect", R"("first": "a.b")", "second"},
                           {"disconnect", R"("second": "a.b")", "first"},
                           {"module_add", R"("name": "net")", "type"},
                           {"module_add", R"("type": "NgNet")", "name"},
                           {"module_remove", R"("type": "NgNet")", "name"},
                           {"quarantine", R"("task": 1)", "why"}}) {
    const std::string data =
        std::string("{\"command\": \"") + each.kind + "\", " + each.members + "}";
    EXPECT_EQ(Wrong(each.kind, data), std::string("has no `") + each.missing + "`") << data;
  }
}

TEST(ChangeJson, WhatIsWrongIsNamed) {
  EXPECT_EQ(Wrong("swap", "{"), "is no JSON object");
  EXPECT_EQ(Wrong("swap", "[]"), "is no JSON object");
  EXPECT_EQ(Wrong("swap", R"({"command": 1})"), "has a wrong `command`");
  EXPECT_EQ(Wrong("swap", R"({"name": "task", "task": 1})"), "is of another kind");
  EXPECT_EQ(Wrong("swap", R"({"command": "load", "name": "a", "task": 1})"), "is of another kind");
  for (const char* task : {"0", "4", "-1", "1.5", "\"1\"", "null", "18446744073709551615"}) {
    EXPECT_EQ(
        Wrong("swap", std::string(R"({"command": "swap", "name": "a", "task": )") + task + "}"),
        "has a wrong `task`")
        << task;
  }
  EXPECT_EQ(Wrong("promote", R"({"command": "promote", "name": "a", "forget": 1})"),
            "has a wrong `forget`");
  EXPECT_EQ(Wrong("promote", R"({"command": "promote", "name": 1})"), "has a wrong `name`");
  EXPECT_EQ(Wrong("set", R"({"command": "set", "name": "a.b", "value": null})"),
            "has a wrong `value`");
  EXPECT_EQ(Wrong("set", R"({"command": "set", "name": "a.b", "value": [1, "2"]})"),
            "has a wrong `value`");
  EXPECT_EQ(
      Wrong("set", R"({"command": "set", "name": "a.b", "from": "1", "to": 2, "episodes": 3})"),
      "has a wrong `from`");
  EXPECT_EQ(Wrong("set", R"({"command": "set", "name": "a.b", "from": 1, "to": 2, "episodes": 0})"),
            "has a wrong `episodes`");
  EXPECT_EQ(Wrong("module_add",
                  R"({"command": "module_add", "type": "A", "name": "a", "parameters": [1]})"),
            "has a wrong `parameters`");
  EXPECT_EQ(
      Wrong("module_add",
            R"({"command": "module_add", "type": "A", "name": "a", "parameters": {"b": null}})"),
      "has a wrong `parameters`");
  EXPECT_EQ(Wrong("quarantine", R"({"command": "quarantine", "change": -3, "why": "loop"})"),
            "has a wrong `change`");
}

}  // namespace
}  // namespace runtime
