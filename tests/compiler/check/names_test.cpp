// What may be called what, and where a name is known.
#include "tests/compiler/check/checked_source.h"

namespace compiler {
namespace {

std::vector<std::string> CodesOf(const std::string& text) {
  const CheckedSource checked(text);
  EXPECT_TRUE(checked.is_parsed) << checked.Messages();
  std::vector<std::string> codes;
  for (const Diagnostic& diagnostic : checked.diagnostics.list()) codes.push_back(diagnostic.code);
  return codes;
}

const std::string kEnd = "  if time > 1 s { truncate_episode \"late\" }\n";

TEST(Names, OfEndedBlocksAreFreeAgain) {
  EXPECT_TRUE(CodesOf(TaskText("", kEnd + "if time > 1 s {\n let x = 1\n reward a = x\n}"
                                          "else {\n let x = 2\n reward a = x\n}"))
                  .empty());
}

TEST(Names, OfTermsAndMetricsAreApartFromValues) {
  EXPECT_TRUE(CodesOf(TaskText("memory fall: real = 0\nmetric fall = fall",
                               kEnd + "fall += 1\nreward rate fall = fall\nreward rate head = 1"))
                  .empty());
}

TEST(Names, OfLinksAreFreeForValues) {
  EXPECT_TRUE(
      CodesOf(TaskText("", kEnd + "let head = contact[head]\nif head { reward a = 1 }")).empty());
}

// Of a robot without any, the words of sites are nobody's.
TEST(Names, OfSitesNeedARobotThatHasThem) {
  const robot::RobotDescription hopper =
      robot::ReadRobot(SOURCE_DIR "/tests/plugins/robots/hopper/robot.toml");
  const auto messages = [&](const std::string& block) {
    Sources sources;
    Diagnostics diagnostics;
    const auto tree = Compose(
        "a.task",
        [&](const std::filesystem::path&) {
          return std::optional("task hop for hopper\non end_of_time_step {\n" + block + "}\n");
        },
        sources, diagnostics);
    Check(*tree, &hopper, diagnostics);
    return Render(sources, diagnostics, false);
  };
  EXPECT_NE(messages("reward rate a = site.position[tip].z / 1 m\n")
                .find("`site.position` is a sensor of sites, and the robot has none"),
            std::string::npos);
  EXPECT_NE(messages("for one in sites { reward a = 1 }\n")
                .find("the robot has no link, joint or group called `sites`"),
            std::string::npos);
  EXPECT_EQ(messages("let site = base.position.z\n" + kEnd + "reward rate a = site / 1 m\n"), "");
}

TEST(Names, DeclaredLaterInTheFileAreKnown) {
  EXPECT_TRUE(CodesOf("task late for humanoid\non end_of_time_step {\n" + kEnd +
                      "reward rate a = gain * kept\nkept = 2\n}\n"
                      "memory kept: real = gain\nparam gain: real = 1\n")
                  .empty());
}

TEST(Names, OfSensorsMayBeChosenWithoutARobot) {
  const CheckedTask task = CheckTask(
      "task bare\nsensor time: real [s]\nsensor base.velocity: vec3 [m/s]\nsensor grip: bool[4]\n"
      "on end_of_time_step {\n  if time > 1 s and any(grip[0, 2..3]) { end_episode success \"x\" "
      "}\n"
      "  reward rate forward = base.velocity.x\n}\n");
  EXPECT_EQ(task.robot, "");
  ASSERT_EQ(task.sensors.size(), 3u);
  EXPECT_EQ(task.sensors[0].name, "time");
  EXPECT_EQ(ToString(task.sensors[1].type), "vec3");
  EXPECT_EQ(ToString(task.sensors[1].unit), "m/s");
  EXPECT_EQ(ToString(task.sensors[2].type), "bool[4]");
}

TEST(Errors, OfADeclarationAreNotRepeatedByItsUses) {
  EXPECT_EQ(CodesOf(TaskText("param gain: reel = 1",
                             "reward rate a = gain * 2\nlet b = gain\nif b > 1 { reward c = b }")),
            std::vector<std::string>{"E0205"});
  EXPECT_EQ(CodesOf("task bare\nsensor base.x: vec9\non end_of_action {\n"
                    "  reward a = base.x.y + 1\n}\n"),
            std::vector<std::string>{"E0205"});
}

TEST(Errors, InBothOperandsAreBothReported) {
  EXPECT_EQ(CodesOf(TaskText("", "reward rate a = unknown_one + unknown_two")),
            (std::vector<std::string>{"E0201", "E0201"}));
}

TEST(Errors, SilenceTheWarnings) {
  EXPECT_EQ(CodesOf(TaskText("param unused: real = 1", "reward rate a = norm(1)")),
            std::vector<std::string>{"E0305"});
}

}  // namespace
}  // namespace compiler
