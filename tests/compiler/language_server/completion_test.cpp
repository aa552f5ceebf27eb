// What an editor offers while one writes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/compiler/language_server/editor.h"

namespace compiler {
namespace {

using protocol::Json;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAre;

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
  EXPECT_THAT(editor.CompleteAt(TaskWith("base.velocity.xy", "site.|")),
              AllOf(Contains("position"), Contains("acceleration")));
  EXPECT_THAT(
      editor.CompleteAt(TaskWith("contact[body, head]", "site.position[|] > 0")),
      AllOf(Contains("sites"), Contains("toes"), Contains("left_toe"), Not(Contains("links"))));
  EXPECT_THAT(editor.HoverAt(TaskWith("base.velocity.xy", "site.acc|eleration[head_top].xy")),
              HasSubstr("sensor site.acceleration: vec3[site] [m/s^2]"));
  EXPECT_THAT(editor.HoverAt(TaskWith("base.velocity.xy", "site.velocity[to|es]")),
              HasSubstr("sites `toes`: left_toe, right_toe"));
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

TEST(Completion, OffersWorldsAndTheSensorsOfTheirThings) {
  Editor editor;
  editor.Write("ball.toml",
               "[[things]]\nname = \"ball\"\nshape = \"sphere\"\nradius = 0.1\nmass = 1\n"
               "position = [1, 0]\n");
  EXPECT_THAT(editor.CompleteAt("task t for humanoid in \"ba|\"\n"), ElementsAre("ball.toml"));
  EXPECT_THAT(editor.CompleteAt("task t for humanoid in \"ball.toml\"\nmetric a = ball.pos|\n"),
              Contains("position"));
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

}  // namespace
}  // namespace compiler
