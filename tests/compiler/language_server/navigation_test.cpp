// Definitions, references and new names.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/compiler/language_server/editor.h"

namespace compiler {
namespace {

using protocol::Json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

TEST(Navigation, FindsTheDefinition) {
  Editor editor;
  const Json place = editor.AskAt("definition", TaskWith("-fall_penalty", "-fall_pe|nalty"));
  EXPECT_EQ(place["uri"], editor.UriOf("asked.task"));
  EXPECT_EQ(Text(place["range"]), "6:6-6:18");
  EXPECT_TRUE(editor.AskAt("definition", TaskWith("norm(", "no|rm(")).is_null());
}

TEST(Navigation, FindsReferences) {
  Editor editor;
  const std::string marked = TaskWith("fallen = true", "fal|len = true");
  EXPECT_THAT(Ranges(editor.AskAt("references", marked)),
              ElementsAre("8:7-8:13", "13:9-13:15", "14:4-14:10"));
  EXPECT_THAT(
      Ranges(editor.AskAt("references", marked, {{"context", {{"includeDeclaration", false}}}})),
      ElementsAre("13:9-13:15", "14:4-14:10"));
  EXPECT_EQ(editor.AskAt("documentHighlight", marked).size(), 3u);
}

TEST(Navigation, WorksInABrokenFile) {
  Editor editor;
  const std::string broken = TaskWith("  fallen = true", "  fal|len = = true");
  EXPECT_EQ(Text(editor.AskAt("definition", broken)["range"]), "8:7-8:13");
  EXPECT_EQ(editor.AskAt("references", broken).size(), 3u);
}

TEST(Navigation, WorksBesideOtherErrors) {
  Editor editor;
  const std::string wrong = TaskWith("speed / 1 m", "unknown");
  const size_t place = wrong.find("-fall_penalty") + 3;
  const std::string marked = wrong.substr(0, place) + "|" + wrong.substr(place);
  EXPECT_EQ(Text(editor.AskAt("definition", marked)["range"]), "6:6-6:18");
}

TEST(Navigation, Renames) {
  Editor editor;
  const std::string marked = TaskWith("fallen = true", "fal|len = true");
  EXPECT_EQ(Text(editor.AskAt("prepareRename", marked)), "14:4-14:10");
  const Json edit = editor.AskAt("rename", marked, {{"newName", "has_fallen"}});
  const Json& edits = edit.at("changes").at(editor.UriOf("asked.task"));
  EXPECT_THAT(Ranges(Json(edits)), UnorderedElementsAre("8:7-8:13", "13:9-13:15", "14:4-14:10"));
  EXPECT_EQ(edits.at(0)["newText"], "has_fallen");
}

// A library, and a task that imports it.
TEST(Navigation, GoesThroughAllFiles) {
  Editor editor;
  const std::string library = "/// How near.\nfn near(d: real) -> real = exp(-d)\n";
  EXPECT_EQ(editor.Open("shaping.task", library).at(0)["params"]["diagnostics"], Json::array());
  editor.Write("user.task", "task user\nimport \"shaping.task\"\nmetric far = near(2)\n");
  const MarkedText at("task t\nimport \"shaping.task\"\nmetric a = n|ear(1)\n");
  editor.Open("a.task", at.text);
  EXPECT_EQ(editor.AskIn("a.task", "definition", at)["uri"], editor.UriOf("shaping.task"));
  EXPECT_EQ(Text(editor.AskIn("a.task", "definition", at)["range"]), "1:3-1:7");
  EXPECT_THAT(editor.AskIn("a.task", "hover", at)["contents"]["value"].get<std::string>(),
              AllOf(HasSubstr("fn near(d: real) -> real"), HasSubstr("How near.")));
  EXPECT_EQ(editor.AskIn("a.task", "references", at).size(), 3u);
  const Json edit = editor.AskIn("a.task", "rename", at, {{"newName", "close_to"}});
  EXPECT_EQ(edit.at("changes").size(), 3u);
  const MarkedText there("/// How near.\nfn ne|ar(d: real) -> real = exp(-d)\n");
  EXPECT_EQ(editor.AskIn("shaping.task", "references", there).size(), 3u);
}

TEST(Navigation, GoesToLibraries) {
  Editor editor;
  const std::string text = "task t\nimport \"std/gait\"\nmetric a = phase_of(1 s, 2 s)\n";
  const auto at = [&](std::string_view marked, std::string_view with) {
    std::string asked = text;
    return asked.replace(asked.find(marked), marked.size(), with);
  };
  const Json file = editor.AskAt("definition", at("std/gait", "std/g|ait"));
  EXPECT_TRUE(file["uri"].get<std::string>().ends_with("library/std/gait.task")) << file;
  const Json function = editor.AskAt("definition", at("phase_of", "pha|se_of"));
  EXPECT_EQ(function["uri"], file["uri"]);
  const Json hover = editor.AskAt("hover", at("std/gait", "std/g|ait"));
  EXPECT_THAT(hover["contents"]["value"].get<std::string>(),
              AllOf(HasSubstr("The rhythm of steps."),
                    HasSubstr("phase_of(time: real [s], period: real [s]) -> real")));
  EXPECT_TRUE(editor.AskAt("hover", at("std/gait", "std/g|ate")).is_null());
  const MarkedText call(at("phase_of", "pha|se_of"));
  editor.Open("asked.task", call.text);
  const Json refused = editor.AskIn("asked.task", "rename", call, {{"newName", "part_of"}});
  EXPECT_THAT(refused["message"].get<std::string>(), HasSubstr("the library `gait`"));
}

TEST(Navigation, KnowsConstsAndSets) {
  Editor editor;
  const MarkedText at("const half: real = 1 / 2\nset so|les = {0, 2}\n");
  editor.Write("user.task",
               "task user\nimport \"shared.task\"\nsensor x: real[3]\n"
               "metric a = sum(x[soles]) * half\non end_of_action {\n"
               "  for i in soles { reward b = half * i }\n}\n");
  EXPECT_EQ(editor.Open("shared.task", at.text).at(0)["params"]["diagnostics"], Json::array());
  EXPECT_EQ(editor.AskIn("shared.task", "references", at).size(), 3u);
  const Json edit = editor.AskIn("shared.task", "rename", at, {{"newName", "ends"}});
  EXPECT_EQ(edit.at("changes").size(), 2u);
  const Json symbols = editor.AskIn("shared.task", "documentSymbol", at);
  EXPECT_EQ(symbols.at(0)["name"], "half");
  EXPECT_EQ(symbols.at(1)["name"], "soles");
}

// A name of its own is one thing, that of what is observed another.
TEST(Navigation, KnowsObservations) {
  const std::string task =
      "task t\nsensor x: real in 0 .. 2\nobserve x\nobserve twice = 2 * x\n"
      "on end_of_time_step { reward rate a = x }\n"
      "test \"b\" { expect observed(x) + observed(twice) == 0 }\n";
  const auto marked = [&](const std::string& before) {
    std::string text = task;
    return text.insert(text.find(before), "|");
  };
  Editor editor;
  EXPECT_EQ(editor.AskAt("rename", marked("twice ="), {{"newName", "double_x"}})
                .at("changes")
                .at(editor.UriOf("asked.task"))
                .size(),
            2u);
  EXPECT_EQ(editor.AskAt("rename", marked("x: real"), {{"newName", "y"}})
                .at("changes")
                .at(editor.UriOf("asked.task"))
                .size(),
            5u);
  EXPECT_THAT(editor.AskAt("hover", marked("twice)"))["contents"]["value"].get<std::string>(),
              AllOf(HasSubstr("observe twice = 2 * x"), HasSubstr("between 0 and 4")));
}

TEST(Navigation, OpensTheFileOfATable) {
  Editor editor;
  editor.Write("curve.csv", "x, y\n0, 1\n2, 3\n");
  for (const char* blank : {" ", "\n    "}) {
    const Json place = editor.AskAt(
        "definition", fmt::format("task t\ntable height: real ={}\"cur|ve.csv\"\n", blank));
    EXPECT_EQ(place["uri"], editor.UriOf("curve.csv"));
  }
}

TEST(Navigation, KnowsPhases) {
  Editor editor;
  const std::string marked =
      "task t for humanoid\nphase reach { if contact[head] { next li|ft } }\n"
      "/// High.\nphase lift within 3 s else lift { if contact[body] { next reach } }\n"
      "metric a = select(phase == lift, 1, 0)\n";
  EXPECT_EQ(Text(editor.AskAt("definition", marked)["range"]), "3:6-3:10");
  EXPECT_EQ(editor.AskAt("references", marked).size(), 4u);
  EXPECT_THAT(editor.HoverAt(marked),
              AllOf(HasSubstr("phase lift within 3 s else lift"), HasSubstr("High.")));
  const Json edit = editor.AskAt("rename", marked, {{"newName", "raise"}});
  EXPECT_THAT(Ranges(edit.at("changes").at(editor.UriOf("asked.task"))),
              UnorderedElementsAre("1:38-1:42", "3:6-3:10", "3:27-3:31", "4:27-4:31"));
}

TEST(Navigation, RefusesNamesThatWouldBeWrong) {
  Editor editor;
  const std::string marked = TaskWith("fallen = true", "fal|len = true");
  for (const char* name : {"fall_penalty", "speed", "norm", "if", "m", "2nd", "a b", "", "base"}) {
    const Json error = editor.AskAt("rename", marked, {{"newName", name}});
    EXPECT_EQ(error.value("code", 0), protocol::kRequestFailed) << name;
  }
  EXPECT_TRUE(editor.AskAt("prepareRename", TaskWith("norm(", "no|rm(")).is_null());
}

}  // namespace
}  // namespace compiler
