// A session with an editor, message by message.
#include "compiler/language_server/language_server.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <random>
#include <sstream>

#include "compiler/language_server/message_stream.h"
#include "compiler/language_server/uri.h"
#include "tests/compiler/language_server/editor.h"
#include "tests/compiler/temporary_folder.h"
#include "tests/golden.h"

namespace compiler {
namespace {

using protocol::Json;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;
using testing::UnorderedElementsAre;

// ---- Life ---------------------------------------------------------------------------------------

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

// ---- Diagnostics --------------------------------------------------------------------------------

TEST(Diagnostics, ArePublishedAsOneTypes) {
  Editor editor;
  auto said = editor.Open("a.task", kTask);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0]["method"], "textDocument/publishDiagnostics");
  EXPECT_EQ(said[0]["params"]["diagnostics"], Json::array());
  const Json change{
      {"range",
       {{"start", {{"line", 11}, {"character", 24}}}, {"end", {{"line", 11}, {"character", 32}}}}},
      {"text", "velosity"}};
  said = editor.Tell("textDocument/didChange",
                     {{"textDocument", {{"uri", editor.UriOf("a.task")}, {"version", 2}}},
                      {"contentChanges", {change}}});
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0]["params"]["version"], 2);
  const Json diagnostic = said[0]["params"]["diagnostics"].at(0);
  EXPECT_EQ(Text(diagnostic["range"]), "11:19-11:32");
  EXPECT_EQ(diagnostic["severity"], 1);
  EXPECT_EQ(diagnostic["code"], "E0202");
  EXPECT_THAT(diagnostic["codeDescription"]["href"].get<std::string>(),
              StartsWith("file:///page.md#e0202-"));
  EXPECT_THAT(diagnostic["message"].get<std::string>(), HasSubstr("did you mean"));
}

TEST(Diagnostics, HaveRelatedPlaces) {
  Editor editor;
  const auto said = editor.Open("a.task", TaskWith("memory fallen", "memory fall_penalty"));
  const Json diagnostic = said.at(0)["params"]["diagnostics"].at(0);
  EXPECT_EQ(Text(diagnostic["relatedInformation"].at(0)["location"]["range"]), "6:6-6:18");
}

TEST(Diagnostics, GoWhenTheFileIsClosed) {
  Editor editor;
  editor.Open("a.task", "task a\nmetric b = c\n");
  const auto said =
      editor.Tell("textDocument/didClose", {{"textDocument", {{"uri", editor.UriOf("a.task")}}}});
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0]["params"]["diagnostics"], Json::array());
}

TEST(Diagnostics, CountColumnsInUtf16) {
  Editor editor;
  const auto said =
      editor.Open("a.task", "task a\non end_of_action { end_episode failure \"😀ä\" let b = c }\n");
  const Json diagnostics = said.at(0)["params"]["diagnostics"];
  EXPECT_EQ(Text(diagnostics.at(0)["range"]), "1:53-1:54");
}

TEST(Diagnostics, OfARobotWithAWrongFileAreGivenInTheTask) {
  Editor editor;
  const auto said = editor.Open("a.task", "task a for nobody\n");
  EXPECT_EQ(said.at(0)["params"]["diagnostics"].at(0)["code"], "E0212");
}

// ---- Hover --------------------------------------------------------------------------------------

TEST(HoverText, ShowsWhatIsDeclared) {
  Editor editor;
  EXPECT_EQ(editor.HoverAt(TaskWith("-fall_penalty", "-fall_pen|alty")),
            "```task\nparam fall_penalty: real = 4 in 0 .. 20\n```\n\nWhat a fall costs.");
  EXPECT_EQ(editor.HoverAt(TaskWith("speed / 1", "spe|ed / 1")),
            "```task\nlet speed: real [m/s]\n```");
  EXPECT_THAT(editor.HoverAt(TaskWith("not fallen", "not f|allen")),
              HasSubstr("memory fallen: bool = false per action"));
}

TEST(HoverText, ShowsTheBoundsOfTerms) {
  Editor editor;
  EXPECT_THAT(
      editor.HoverAt(TaskWith("  if time", "  reward co|st = -1 - fall_penalty\n  if time")),
      HasSubstr("between -21 and -1 each time"));
}

TEST(HoverText, ShowsSensorsAndTheRobot) {
  Editor editor;
  EXPECT_THAT(editor.HoverAt(TaskWith("base.velocity.xy", "base.velo|city.xy")),
              AllOf(HasSubstr("sensor base.velocity: vec3 [m/s]"), HasSubstr("world")));
  EXPECT_THAT(editor.HoverAt(TaskWith("[body, head]", "[bo|dy, head]")), HasSubstr("link"));
  EXPECT_THAT(editor.HoverAt(TaskWith("[body, head]", "[le|gs, head]")), HasSubstr("links `legs`"));
  EXPECT_THAT(editor.HoverAt(TaskWith("for humanoid", "for huma|noid")), HasSubstr("17 joints"));
  EXPECT_THAT(editor.HoverAt(TaskWith("start standing", "start stan|ding")), HasSubstr("pose"));
}

TEST(HoverText, ShowsTheLanguagesOwnWords) {
  Editor editor;
  EXPECT_THAT(editor.HoverAt(TaskWith("norm(", "no|rm(")), HasSubstr("norm(v)"));
  EXPECT_THAT(editor.HoverAt(TaskWith("20 s ", "20 s| ")), HasSubstr("unit"));
  EXPECT_THAT(editor.HoverAt(TaskWith("truncate_episode", "truncate|_episode")),
              HasSubstr("limit"));
  EXPECT_THAT(editor.HoverAt(TaskWith("on end_of_time_step", "on end_of|_time_step")),
              HasSubstr("After each time step"));
  EXPECT_EQ(editor.HoverAt(TaskWith("{", "|{")), "");
  EXPECT_EQ(editor.HoverAt(TaskWith("/// Move", "/// Mo|ve")), "");
}

TEST(HoverText, IsThereInABrokenFile) {
  Editor editor;
  const std::string broken = TaskWith("start standing", "start standing\nparam broken: = (");
  const size_t place = broken.find("-fall_penalty") + 4;
  EXPECT_THAT(editor.HoverAt(broken.substr(0, place) + "|" + broken.substr(place)),
              HasSubstr("param fall_penalty: real"));
}

TEST(HoverText, TellsWhatConstsAndSetsStandFor) {
  Editor editor;
  const std::string task =
      "task t for humanoid\n/// How far.\nconst reach: real [m] = 5 cm\n"
      "set soles = feet\nmetric a = count(contact[soles]) / (reach / 1 m)\n";
  const auto hover = [&](const std::string& word) {
    const size_t place = task.rfind(word) + 1;
    return editor.HoverAt(task.substr(0, place) + "|" + task.substr(place));
  };
  EXPECT_THAT(hover("reach"), AllOf(HasSubstr("const reach: real [m] = 5 cm"), HasSubstr("0.05 m"),
                                    HasSubstr("How far.")));
  EXPECT_THAT(hover("soles"),
              AllOf(HasSubstr("set soles = feet"), HasSubstr("left_foot, right_foot")));
}

TEST(HoverText, TellsHowManyRowsATableHas) {
  Editor editor;
  editor.Write("curve.csv", "time [s], height [cm]\n0, 1\n0.5, 2\n2, 3\n");
  const std::string task =
      "task t for humanoid\n/// A curve.\ntable height: real [m] = \"curve.csv\"\n"
      "metric a = hei|ght(time, loop) / 1 m\n";
  EXPECT_THAT(editor.HoverAt(task),
              AllOf(HasSubstr("table height: real [m] = \"curve.csv\""),
                    HasSubstr("3 rows, time from 0 to 2 s"), HasSubstr("A curve.")));
}

// ---- Completion ---------------------------------------------------------------------------------

TEST(Completion, OffersSensorsAndElements) {
  Editor editor;
  EXPECT_THAT(editor.CompleteAt(TaskWith("base.velocity.xy", "base.|")),
              AllOf(Contains("velocity"), Contains("up"), Not(Contains("angle"))));
  EXPECT_THAT(editor.CompleteAt(TaskWith("base.velocity.xy", "base.velocity.|")),
              ElementsAre("x", "y", "z", "xy"));
  EXPECT_THAT(editor.CompleteAt(TaskWith("base.velocity.xy", "base.orientation.|")),
              ElementsAre("w", "x", "y", "z"));
  EXPECT_THAT(editor.HoverAt(TaskWith("base.velocity.xy", "joint.l|ow[0]")),
              HasSubstr("constant joint.low: real[joint] [rad]"));
  EXPECT_THAT(editor.CompleteAt(TaskWith("base.velocity.xy", "joint.|")),
              AllOf(Contains("target"), Contains("low"), Contains("rest")));
  EXPECT_THAT(editor.CompleteAt(TaskWith("base.velocity.xy", "link.position.|")),
              ElementsAre("x", "y", "z", "xy"));
  EXPECT_THAT(editor.CompleteAt(TaskWith("base.velocity.xy", "link.position[feet].|")),
              ElementsAre("x", "y", "z", "xy"));
}

TEST(Completion, OffersPartsInsideBrackets) {
  Editor editor;
  EXPECT_THAT(editor.CompleteAt(TaskWith("[body, head]", "[body, |")),
              AllOf(Contains("head"), Contains("feet"), Contains("links"), Not(Contains("joints")),
                    Not(Contains("norm"))));
  EXPECT_THAT(editor.CompleteAt(TaskWith("contact[body, head]", "joint.angle[|] > 0")),
              AllOf(Contains("joints"), Not(Contains("links"))));
}

TEST(Completion, OffersWordsByPlace) {
  Editor editor;
  EXPECT_THAT(editor.CompleteAt(TaskWith("start standing", "|")),
              AllOf(Contains("param"), Contains("on"), Not(Contains("let"))));
  EXPECT_THAT(editor.CompleteAt(TaskWith("start standing", "start |")), Contains("lying"));
  EXPECT_THAT(editor.CompleteAt(TaskWith("for humanoid", "for |")), Contains("humanoid"));
  EXPECT_THAT(editor.CompleteAt(TaskWith("on end_of_time_step", "on |")),
              Contains("end_of_action"));
  EXPECT_THAT(editor.CompleteAt(TaskWith("per action", "per |")),
              ElementsAre("action", "episode", "run"));
  EXPECT_THAT(editor.CompleteAt(TaskWith("  fallen = true", "  |")),
              AllOf(Contains("if"), Contains("fallen"), Not(Contains("param"))));
  EXPECT_THAT(editor.CompleteAt(TaskWith("20 s ", "20 |")), AllOf(Contains("s"), Contains("deg")));
  EXPECT_THAT(editor.CompleteAt(TaskWith("memory fallen: bool", "memory fallen: |")),
              AllOf(Contains("bool"), Contains("vec3")));
  EXPECT_THAT(editor.CompleteAt(TaskWith("reward fall =", "reward |")),
              AllOf(Contains("rate"), Contains("forward")));
  EXPECT_THAT(editor.CompleteAt(TaskWith("/// Move", "allow |\n/// Move")), Contains("W0703"));
}

TEST(Completion, OffersValuesThatAreVisible) {
  Editor editor;
  const auto values = editor.CompleteAt(TaskWith("-fall_penalty", "-|"));
  EXPECT_THAT(values, AllOf(Contains("fall_penalty"), Contains("fallen"), Contains("speed"),
                            Contains("base.position"), Contains("clamp"), Contains("pi")));
  EXPECT_THAT(values, Not(Contains("forward"))) << "terms are never read";
  EXPECT_THAT(editor.CompleteAt(TaskWith("norm(base.velocity.xy)", "|")), Not(Contains("speed")));
  EXPECT_THAT(editor.CompleteAt(TaskWith("\"time is up\"", "\"time |\"")), IsEmpty());
}

TEST(Completion, OffersConstsAndSets) {
  Editor editor;
  const std::string task = "task t for humanoid\nconst reach: real [m] = 5 cm\nset soles = feet\n";
  EXPECT_THAT(editor.CompleteAt(task + "metric a = |"),
              AllOf(Contains("reach"), Not(Contains("soles"))));
  EXPECT_THAT(editor.CompleteAt(task + "metric a = count(contact[|])"),
              AllOf(Contains("soles"), Contains("feet"), Not(Contains("reach"))));
  EXPECT_THAT(editor.CompleteAt(task + "set others = links - |"),
              AllOf(Contains("soles"), Contains("hands"), Contains("left_knee_pitch")));
  editor.Write("base.task", task);
  const std::string own = "task a extends \"base.task\"\n";
  editor.CompleteAt(own + "|");  // a text without mistakes, from which the base is known
  EXPECT_THAT(editor.CompleteAt(own + "override |"), AllOf(Contains("const"), Contains("set")));
  EXPECT_THAT(editor.CompleteAt(own + "override const |"), ElementsAre("reach"));
  EXPECT_THAT(editor.CompleteAt(own + "override set |"), ElementsAre("soles"));
}

TEST(Completion, OffersWhatIsObserved) {
  Editor editor;
  const std::string task =
      "task t for humanoid\ngoal way: real = uniform(0, 1)\nobserve clock = way\n"
      "on end_of_action { reward a = way }\n";
  EXPECT_THAT(
      editor.CompleteAt(task + "observe |"),
      AllOf(Contains("onboard"), Contains("way"), Contains("smooth"), Not(Contains("clock"))));
  EXPECT_THAT(editor.CompleteAt(task + "test \"b\" { expect observed(|) > 0 }"), Contains("clock"));
  editor.Write("base.task", task);
  const std::string own = "task a extends \"base.task\"\n";
  editor.CompleteAt(own + "|");
  EXPECT_THAT(editor.CompleteAt(own + "override |"), Contains("observe"));
  EXPECT_THAT(editor.CompleteAt(own + "override observe |"), ElementsAre("clock"));
}

TEST(Completion, OffersTables) {
  Editor editor;
  editor.Write("curve.csv", "time [s], height [cm]\n0, 1\n2, 3\n");
  const std::string table = "table height: real [m] = \"curve.csv\"\n";
  const std::string task = "task t for humanoid\n" + table;
  EXPECT_THAT(editor.CompleteAt(task + "metric a = |"),
              AllOf(Contains("height"), Contains("duration"), Not(Contains("loop"))));
  EXPECT_THAT(editor.CompleteAt(task + "metric a = height(time, |)"), Contains("loop"));
  EXPECT_THAT(editor.CompleteAt("task t\ntable a: real = \"cu|\"\n"), ElementsAre("curve.csv"));
  editor.Write("base.task", task);
  const std::string own = "task a extends \"base.task\"\n";
  editor.CompleteAt(own + "|");
  EXPECT_THAT(editor.CompleteAt(own + "override |"), Contains("table"));
  EXPECT_THAT(editor.CompleteAt(own + "override table |"), ElementsAre("height"));
  EXPECT_THAT(editor.CompleteAt(own + "override table height = \"|\""), ElementsAre("curve.csv"));
}

TEST(Completion, OffersPhases) {
  Editor editor;
  const std::string task =
      "task t for humanoid\nphase reach { if contact[head] { next lift } }\n"
      "phase lift within 3 s else reach { if contact[head] { next reach } }\n";
  const std::string block = task + "on end_of_time_step { if ";
  EXPECT_THAT(editor.CompleteAt(block + "|"),
              AllOf(Contains("phase"), Contains("phase_time"), Not(Contains("lift"))));
  EXPECT_THAT(editor.CompleteAt(block + "phase == |"), UnorderedElementsAre("reach", "lift"));
  EXPECT_THAT(editor.CompleteAt(task + "phase hold { next |"),
              UnorderedElementsAre("reach", "lift", "hold"));
  EXPECT_THAT(editor.CompleteAt("task t for humanoid\non end_of_time_step { if |"),
              Not(Contains("phase_time")));
}

TEST(Completion, ReplacesTheWord) {
  Editor editor;
  const Json list = editor.AskAt("completion", TaskWith("-fall_penalty", "-fall_|"));
  for (const Json& item : list["items"]) {
    if (item["label"] != "fall_penalty") continue;
    EXPECT_EQ(Text(item["textEdit"]["range"]), "15:19-15:24");
    EXPECT_EQ(item["detail"], "real");
    EXPECT_EQ(item["documentation"]["value"], "What a fall costs.");
    return;
  }
  ADD_FAILURE() << list;
}

TEST(Completion, OffersTaskFiles) {
  Editor editor;
  editor.Write("shaping.task", "fn near(d: real) -> real = d\n");
  EXPECT_THAT(editor.CompleteAt("task t extends \"sh|\"\n"), ElementsAre("shaping.task"));
  EXPECT_THAT(editor.CompleteAt("task t\nimport \"sh|\"\n"), Contains("shaping.task"));
}

TEST(Completion, OffersLibraries) {
  Editor editor;
  EXPECT_THAT(editor.CompleteAt("task t\nimport \"st|\"\n"),
              ElementsAre("std/frames", "std/gait", "std/kernels", "std/tolerance"));
  EXPECT_THAT(editor.CompleteAt("task t extends \"st|\"\n"), IsEmpty());
}

TEST(Completion, OffersTheOpenUnitInFunctions) {
  Editor editor;
  EXPECT_THAT(editor.CompleteAt("task t\nfn f(x: real [|]) -> real = 1\n"), Contains("unit"));
  EXPECT_THAT(editor.CompleteAt("task t\nparam p: real [|] = 1\n"), Not(Contains("unit")));
}

// ---- Navigation ---------------------------------------------------------------------------------

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

TEST(Diagnostics, OfATableAreGivenInItsFile) {
  Editor editor;
  editor.Write("curve.csv", "x, y\n0, 1\n2, three\n");
  const std::vector<Json> published =
      editor.Open("a.task", "task t\ntable height: real = \"curve.csv\"\n");
  const auto of_table = std::ranges::find_if(published, [&](const Json& each) {
    return each["params"]["uri"] == editor.UriOf("curve.csv");
  });
  ASSERT_NE(of_table, published.end());
  EXPECT_EQ((*of_table)["params"]["diagnostics"].at(0)["code"], "E0671");
  EXPECT_EQ(Text((*of_table)["params"]["diagnostics"].at(0)["range"]), "2:3-2:8");
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

// ---- The rest -----------------------------------------------------------------------------------

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
