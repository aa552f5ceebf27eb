// What an editor shows where the cursor rests.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/compiler/language_server/editor.h"

namespace compiler {
namespace {

using testing::AllOf;
using testing::HasSubstr;

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

}  // namespace
}  // namespace compiler
