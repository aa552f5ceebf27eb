// Where the warnings that come from bounds must stay silent.
#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "compiler/analyze/analyze.h"

namespace compiler {
namespace {

std::vector<std::string> WarningsOf(const std::string& text) {
  const auto read = [&](const std::filesystem::path&) { return text; };
  const Analysis analysis = Analyze("a.task", read, SOURCE_DIR "/plugins");
  EXPECT_TRUE(analysis.task) << Render(analysis.sources, analysis.diagnostics, false);
  std::vector<std::string> codes;
  for (const Diagnostic& diagnostic : analysis.diagnostics.list()) codes.push_back(diagnostic.code);
  return codes;
}

// Of a task with these declarations and statements at the end of each time step.
std::vector<std::string> WarningsIn(const std::string& declarations, const std::string& block) {
  return WarningsOf("task tested for humanoid\n" + declarations + "\non end_of_time_step {\n" +
                    block + "\nif time > 20 s { truncate_episode \"time is up\" }\n}\n");
}

using testing::ElementsAre;
using testing::IsEmpty;

TEST(BoundsWarnings, AreNotGivenForRequirementsThatHold) {
  EXPECT_THAT(WarningsIn("", "require abs(base.position.x) < 1 km"), IsEmpty());
}

TEST(BoundsWarnings, AreNotGivenForConditionsThatAreAlwaysTrueButHaveNoElse) {
  EXPECT_THAT(WarningsIn("", "if base.position.z > -1 m { reward rate up = base.position.z }"),
              IsEmpty());
}

TEST(BoundsWarnings, AreNotGivenForWhatHappensInOnePassOfALoop) {
  EXPECT_THAT(WarningsIn("", "for i in 0..3 {\n  if i > 2 { reward rate a = base.velocity.x }\n}"),
              testing::Not(testing::Contains("W0711")));
}

TEST(BoundsWarnings, AreNotGivenForSmallPaymentsBesideRates) {
  EXPECT_THAT(WarningsIn("",
                         "reward rate forward = 50 * base.velocity.x\n"
                         "if contact[head] { reward fall = -0.01 }"),
              IsEmpty());
}

TEST(BoundsWarnings, AreNotGivenForSensorsWithoutRange) {
  EXPECT_THAT(WarningsOf("task tested\nsensor speed: real [m/s]\nsensor clock: real [s]\n"
                         "on end_of_time_step {\n"
                         "  reward rate forward = 2 m/s * speed - speed * speed\n"
                         "  if clock > 1 s { truncate_episode \"time is up\" }\n}\n"),
              IsEmpty());
}

TEST(BoundsWarnings, AreNotGivenForSumsOfAnAction) {
  EXPECT_THAT(WarningsOf("task tested for humanoid\nmemory pushed: real [N m s] = 0 per action\n"
                         "on end_of_time_step {\n"
                         "  pushed += norm(joint.torque) * time_step\n"
                         "  if time > 20 s { truncate_episode \"time is up\" }\n}\n"
                         "on end_of_action { reward effort = -pushed }\n"),
              IsEmpty());
}

TEST(BoundsWarnings, AreNotGivenForWhatWasSensedBefore) {
  EXPECT_THAT(WarningsIn("memory before: real [m] = 0 m",
                         "reward rate progress = (base.position.x - before) / 1 s\n"
                         "before = base.position.x"),
              IsEmpty());
}

TEST(BoundsWarnings, AreNotGivenForMemoryThatOnlyAnEndDependsOn) {
  EXPECT_THAT(WarningsIn("memory sum_of_reward: real = 0",
                         "reward rate forward = base.velocity.x\nsum_of_reward += reward\n"
                         "if sum_of_reward < -40 { end_episode failure \"falls too often\" }"),
              IsEmpty());
}

TEST(BoundsWarnings, AreNotGivenForOnceAnEpisode) {
  EXPECT_THAT(WarningsIn("", "once per episode if base.position.x > 1 m { reward line = 10 }"),
              IsEmpty());
}

TEST(BoundsWarnings, OfTinyTermsAreNotGivenForWhatOnlyBoundsMakeTiny) {
  // The joints' velocities are bounded by 2,886 rad/s in norm; a robot reaches 20.
  EXPECT_THAT(WarningsIn("",
                         "reward rate upright = base.up.z\n"
                         "reward rate motion = -norm(joint.velocity)"),
              IsEmpty());
  EXPECT_THAT(WarningsIn("",
                         "reward rate upright = 0.001 * base.up.z\n"
                         "reward rate motion = -norm(joint.velocity)"),
              ElementsAre("W0713"));
}

TEST(BoundsWarnings, OfEarlyDeathAreNotGivenWhereSomethingIsToBeGained) {
  const std::string end = "if contact[head] { end_episode failure \"falls\" }\n";
  EXPECT_THAT(WarningsIn("", "reward rate up = base.up.z - 1.0\n" + end), ElementsAre("W0715"));
  EXPECT_THAT(WarningsIn("", "reward rate up = -acos(base.up.z) / 1 rad\n" + end),
              ElementsAre("W0715"));
  EXPECT_THAT(WarningsIn("", "reward rate up = base.up.z\n" + end), IsEmpty());
  EXPECT_THAT(WarningsIn("", "reward rate waiting = -1\n" + end +
                                 "if base.position.x > 1 m { reward line = 10 end_episode success "
                                 "\"arrives\" }\n"
                                 "if base.position.x < -1 m { end_episode failure \"flees\" }"),
              IsEmpty());
}

// What it takes for a way it gives for the way back: it neither makes dying pay nor living.
TEST(BoundsWarnings, OfEarlyDeathTakeAPotentialForNothing) {
  const std::string near = "reward potential near = -norm(base.position) / 1 m\n";
  const std::string end = "if contact[head] { end_episode failure \"falls\" }\n";
  EXPECT_THAT(WarningsIn(near, end), IsEmpty());
  EXPECT_THAT(WarningsIn(near, "reward rate waiting = -1\n" + end), ElementsAre("W0715"));
}

TEST(BoundsWarnings, OfEarlyDeathTakeNoUnknownCostForALargeOne) {
  const auto falling = [](const std::string& payment) {
    return WarningsOf(
        "task tested\nsensor force: real[4]\nsensor tilt: real in -1 .. 1\n"
        "on end_of_time_step {\n  reward rate effort = -norm(force)\n"
        "  if tilt > 0.5 { " +
        payment + "end_episode failure \"falls\" }\n}\n");
  };
  EXPECT_THAT(falling("reward fall = -1 "), IsEmpty());
  EXPECT_THAT(falling(""), ElementsAre("W0715"));
}

TEST(BoundsWarnings, OfEarlyDeathAreNotGivenWhereFailingCosts) {
  const std::string waiting = "reward rate waiting = -1\n";
  const std::string end = "end_episode failure \"falls\"";
  EXPECT_THAT(WarningsIn("", waiting + "if contact[head] { reward fall = -29 " + end + " }"),
              IsEmpty());
  EXPECT_THAT(WarningsIn("", waiting +
                                 "if contact[head] { reward fall = -29 }\n"
                                 "if contact[head] { " +
                                 end + " }"),
              IsEmpty());
  EXPECT_THAT(
      WarningsIn("memory fallen: bool = false per action", waiting +
                                                               "if fallen { reward fall = -29 }\n"
                                                               "if contact[head] { fallen = true " +
                                                               end + " }"),
      IsEmpty());
  EXPECT_THAT(WarningsIn("", waiting + "if contact[head] { " + end +
                                 " }\n"
                                 "if base.position.x > 1 m { reward arrived = 10 }"),
              IsEmpty());
  EXPECT_THAT(WarningsIn("", waiting + "if contact[head] { " + end + " }"), ElementsAre("W0715"));
}

TEST(EndWarnings, AreNotGivenWhereAnEndStopsTheTask) {
  EXPECT_THAT(WarningsIn("",
                         "reward rate up = base.up.z\n"
                         "if contact[head] { reward fall = -2 end_episode failure \"falls\" }"),
              IsEmpty());
}

TEST(EndWarnings, AreNotGivenForEpisodesOfOneAction) {
  EXPECT_THAT(
      WarningsOf("task tested for humanoid\n"
                 "on end_of_action { reward up = base.up.z end_episode success \"done\" }\n"),
      IsEmpty());
}

TEST(DomainWarnings, AreNotGivenForSensorsWithoutRange) {
  EXPECT_THAT(WarningsOf("task tested\nsensor speed: real\nsensor time: real [s]\n"
                         "on end_of_time_step {\n"
                         "  reward rate root = tanh(sqrt(speed))\n"
                         "  if time > 1 s { truncate_episode \"time is up\" }\n}\n"),
              IsEmpty());
}

TEST(Allowances, SilenceWhatTheyNameWithinWhatTheyCover) {
  const std::string tiny = "reward rate effort = -1e-5 * norm(joint.torque)\n";
  const std::string large = "reward rate forward = 50 * base.velocity.x";
  EXPECT_THAT(WarningsIn("", tiny + large), ElementsAre("W0713"));
  EXPECT_THAT(WarningsIn("", "  allow W0713\n" + tiny + large), IsEmpty());
  EXPECT_THAT(WarningsIn("", "  allow W0706\n" + tiny + large), ElementsAre("W0710", "W0713"));
  EXPECT_THAT(WarningsIn("", tiny + "  allow W0713\n" + large), ElementsAre("W0713", "W0710"));
  EXPECT_THAT(WarningsOf("allow W0707\ntask tested for humanoid\n"), IsEmpty());
}

}  // namespace
}  // namespace compiler
