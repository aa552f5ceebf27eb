// A start is drawn again where links would be inside each other.
#include <gmock/gmock.h>

#include "runtime/training/simulation/link_overlap.h"
#include "runtime/training/simulation/robot_environment.h"
#include "tests/runtime/training/simulation/robots.h"

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::MatchesRegex;

// Standing, with the legs turned toward each other [rad].
robot::StartState Crossed(double roll) {
  robot::StartState start = robot::RestIn(*Humanoid().FindPose("standing"));
  start.pose.joint_angles[*Humanoid().FindJoint("left_hip_roll")] = roll;
  start.pose.joint_angles[*Humanoid().FindJoint("right_hip_roll")] = -roll;
  return start;
}

// Other ones, but none without an overlap.
robot::StartState AlwaysCrossed(uint32_t attempt) { return Crossed(0.2 + 0.001 * attempt); }

struct StartListener : Module {
  StartListener() : Module("listener") {}
  void EndOfEpisode(EpisodeEnd end) {
    EXPECT_EQ(end.kind, EndKind::kDiverged);
    reason = end.reason;
  }
  Slot<EpisodeEnd> end_of_episode{this, "end_of_episode", Bind<&StartListener::EndOfEpisode>{}};
  std::string reason;
};

class DrawnStartTest : public testing::TestWithParam<const char*> {
 protected:
  DrawnStartTest() {
    Port::Connect(environment_.FindPort("end_of_episode"), listener_.end_of_episode);
    environment_.Set("profile", std::string(GetParam()));
    environment_.Start();
  }

  double Roll() {
    auto& angles = static_cast<SensorOut&>(environment_.FindPort("joint.angle"));
    return angles().reals()[*Humanoid().FindJoint("left_hip_roll")];
  }

  StartListener listener_;
  RobotEnvironment environment_{"environment", Context{&Humanoid(), {}, 0}};
};

TEST_P(DrawnStartTest, IsTheFirstWithoutAnOverlap) {
  std::vector<uint32_t> attempts;
  environment_.StartDrawnEpisode([&](uint32_t attempt) {
    attempts.push_back(attempt);
    return Crossed(0.3 - 0.1 * attempt);
  });
  EXPECT_THAT(attempts, ElementsAre(0, 1, 2, 3));
  EXPECT_NEAR(Roll(), 0, 1e-9);
  environment_.RunTimeStep();
  EXPECT_EQ(environment_.time(), 0.005);
  EXPECT_EQ(listener_.reason, "");
}

TEST_P(DrawnStartTest, IsTakenAsItIsWhereNothingIsDrawn) {
  environment_.StartDrawnEpisode([&](uint32_t) { return Crossed(0.1); });
  EXPECT_NEAR(Roll(), 0.1, 1e-9);
  EXPECT_EQ(listener_.reason, "");
}

TEST_P(DrawnStartTest, IsDrawnOnceWhereTheAgentSaysThePose) {
  environment_.Set("start_pose", std::string("sitting"));
  int draws = 0;
  environment_.StartDrawnEpisode([&](uint32_t attempt) {
    ++draws;
    return AlwaysCrossed(attempt);
  });
  EXPECT_EQ(draws, 1);
  EXPECT_NEAR(Roll(), -0.0039, 1e-3);
  EXPECT_EQ(listener_.reason, "");
}

TEST_P(DrawnStartTest, EndsTheEpisodeWhereAllDrawsHaveAnOverlap) {
  environment_.StartDrawnEpisode(AlwaysCrossed);
  EXPECT_THAT(listener_.reason,
              MatchesRegex("links overlap in each of 100 starts that were drawn: `[a-z_]+` and "
                           "`[a-z_]+` by [0-9.]+ mm in the last one"));
  environment_.RunTimeStep();
  EXPECT_EQ(environment_.time(), 0);
  std::vector<float> pose(7 * Humanoid().links.size());
  environment_.CapturePose(pose);
  EXPECT_NEAR(pose[2], 0.24, 0.01);  // it can be seen
  environment_.StartDrawnEpisode([](uint32_t) { return Crossed(0); });
  environment_.RunTimeStep();
  EXPECT_EQ(environment_.time(), 0.005);
}

INSTANTIATE_TEST_SUITE_P(Profiles, DrawnStartTest, testing::Values("paper", "fast-tree"),
                         ProfileInName);

// Of a robot that overlaps in the pose itself, only what is deeper counts.
TEST(LinkOverlap, IsWhatThePoseDoesNotHave) {
  const auto find = [&](double roll) {
    robot::StartState start = Crossed(roll);
    start.from = Crossed(0.1).pose;
    const Profile& profile = FindProfile("paper");
    return FindOverlap(Humanoid(), profile, start, World(Humanoid(), profile, start));
  };
  EXPECT_FALSE(find(0.1));
  EXPECT_FALSE(find(0.05));
  const std::optional<LinkOverlap> overlap = find(0.15);
  ASSERT_TRUE(overlap);
  EXPECT_LT(overlap->first, overlap->second);
  EXPECT_GT(overlap->depth, 0.001);
}

}  // namespace
}  // namespace runtime
