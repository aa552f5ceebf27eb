#include "runtime/training/simulation/robot_environment.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

#include "tests/runtime/training/simulation/robots.h"

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// Listens to all signals of an environment and drives its joints.
class Listener : public Module {
 public:
  Listener() : Module("listener") {}

  std::vector<std::string> events;
  std::vector<double> lengths;
  std::string end_reason;
  Eigen::VectorXd targets;
  std::function<void()> when_time_step_starts = [] {};
  std::function<void()> when_physics_step_ends = [] {};

  void StartOfEpisode() { events.push_back("start_of_episode"); }
  void StartOfTimeStep(double length) {
    Note("start_of_time_step", length);
    when_time_step_starts();
  }
  void StartOfPhysicsStep(double length) { Note("start_of_physics_step", length); }
  void EndOfPhysicsStep(double length) {
    Note("end_of_physics_step", length);
    when_physics_step_ends();
  }
  void EndOfTimeStep(double length) { Note("end_of_time_step", length); }
  void EndOfEpisode(EpisodeEnd end) {
    events.push_back(end.kind == EndKind::kDiverged ? "diverged" : "another end");
    end_reason = end.reason;
  }

  Slot<> start_of_episode{this, "start_of_episode", Bind<&Listener::StartOfEpisode>{}};
  Slot<double> start_of_time_step{this, "start_of_time_step", Bind<&Listener::StartOfTimeStep>{}};
  Slot<double> start_of_physics_step{this, "start_of_physics_step",
                                     Bind<&Listener::StartOfPhysicsStep>{}};
  Slot<double> end_of_physics_step{this, "end_of_physics_step",
                                   Bind<&Listener::EndOfPhysicsStep>{}};
  Slot<double> end_of_time_step{this, "end_of_time_step", Bind<&Listener::EndOfTimeStep>{}};
  Slot<EpisodeEnd> end_of_episode{this, "end_of_episode", Bind<&Listener::EndOfEpisode>{}};
  Out<Eigen::VectorXd> joint_targets{this, "joint_targets", &targets};

 private:
  void Note(const char* event, double length) {
    events.push_back(event);
    lengths.push_back(length);
  }
};

struct Stage {
  explicit Stage(const robot::RobotDescription& robot = Humanoid(), const char* profile = "paper",
                 const char* pose = "")
      : environment("environment", Context{&robot, {}, 0}) {
    listener.targets = Eigen::VectorXd::Zero(robot.joints.size());
    for (Port* port : listener.ports()) {
      Port::Connect(environment.FindPort(port->name()), *port);
    }
    environment.Set("profile", std::string(profile));
    environment.Set("start_pose", std::string(pose));
    environment.Start();
  }

  const SensorData& Read(const char* sensor) {
    return static_cast<SensorOut&>(environment.FindPort(sensor))();
  }
  double Real(const char* sensor, int index = 0) { return Read(sensor).reals()[index]; }

  Listener listener;
  RobotEnvironment environment;
};

std::vector<std::string> TimeStep(int physics_steps) {
  std::vector<std::string> events = {"start_of_time_step"};
  for (int i = 0; i < physics_steps; ++i) {
    events.push_back("start_of_physics_step");
    events.push_back("end_of_physics_step");
  }
  events.push_back("end_of_time_step");
  return events;
}

TEST(RobotEnvironment, EventsHaveTheOrderOfTheDocumentation) {
  Stage stage;
  stage.environment.StartEpisode();
  EXPECT_THAT(stage.listener.events, ElementsAre("start_of_episode"));
  stage.listener.events.clear();
  stage.environment.RunTimeStep();
  EXPECT_EQ(stage.listener.events, TimeStep(25));
  stage.listener.events.clear();
  stage.environment.RunTimeStep();
  EXPECT_EQ(stage.listener.events, TimeStep(25));
}

TEST(RobotEnvironment, SignalsCarryTheLengthOfTheirStep) {
  Stage stage;
  stage.environment.StartEpisode();
  stage.environment.RunTimeStep();
  ASSERT_EQ(stage.listener.lengths.size(), 52u);
  EXPECT_EQ(stage.listener.lengths.front(), 0.005);
  EXPECT_EQ(stage.listener.lengths.back(), 0.005);
  for (int i = 1; i <= 50; ++i) EXPECT_DOUBLE_EQ(stage.listener.lengths[i], 0.0002);
}

TEST(RobotEnvironment, AnotherRobotHasItsOwnTimeStep) {
  Stage stage(Hopper());
  stage.environment.StartEpisode();
  stage.listener.events.clear();
  stage.environment.RunTimeStep();
  EXPECT_EQ(stage.environment.time_step(), 0.01);
  EXPECT_EQ(stage.environment.pose_count(), 3);
  EXPECT_EQ(stage.listener.events, TimeStep(50));
}

TEST(RobotEnvironment, TargetsOfAnotherRobotAreRefused) {
  Stage stage(Hopper());
  stage.environment.StartEpisode();
  stage.listener.targets = Eigen::VectorXd::Zero(17);
  try {
    stage.environment.RunTimeStep();
    FAIL() << "17 targets for two joints";
  } catch (const UserError& error) {
    EXPECT_STREQ(error.what(),
                 "`environment` gets 17 joint targets, and the robot `hopper` has 2 joints");
  }
}

TEST(RobotEnvironment, TimeIsCountedWithoutDrift) {
  Stage stage(Humanoid(), "fast");
  stage.environment.StartEpisode();
  EXPECT_EQ(stage.environment.time(), 0);
  std::vector<double> times;
  stage.listener.when_physics_step_ends = [&] { times.push_back(stage.Real("time")); };
  stage.environment.RunTimeStep();
  const size_t steps = times.size();
  for (size_t i = 0; i < steps; ++i) EXPECT_DOUBLE_EQ(times[i], 0.005 * (i + 1) / steps);
  for (int i = 1; i < 200; ++i) stage.environment.RunTimeStep();
  EXPECT_EQ(stage.environment.time(), 1.0);
  EXPECT_EQ(stage.Real("time"), 1.0);
}

TEST(RobotEnvironment, EveryEpisodeStartsAfresh) {
  Stage stage(Humanoid(), "fast");
  const auto run = [&] {
    stage.environment.StartEpisode();
    EXPECT_EQ(stage.environment.time(), 0);
    EXPECT_EQ(stage.Real("base.position", 2), 0.242095);
    stage.listener.targets.setConstant(0.3);
    for (int i = 0; i < 100; ++i) stage.environment.RunTimeStep();
    std::vector<float> pose(7 * 18);
    stage.environment.CapturePose(pose);
    return pose;
  };
  const std::vector<float> first = run();
  EXPECT_EQ(run(), first);
  Stage other(Humanoid(), "fast");
  other.listener.targets.setConstant(0.3);
  other.environment.StartEpisode();
  for (int i = 0; i < 100; ++i) other.environment.RunTimeStep();
  std::vector<float> pose(7 * 18);
  other.environment.CapturePose(pose);
  EXPECT_EQ(std::memcmp(pose.data(), first.data(), pose.size() * sizeof(float)), 0);
}

TEST(RobotEnvironment, StartsFromTheChosenPose) {
  Stage stage(Humanoid(), "paper", "lying");
  stage.environment.StartEpisode();
  EXPECT_EQ(stage.Real("base.position", 2), 0.0333726);
  EXPECT_NEAR(stage.Real("joint.angle", 1), 2.59599, 1e-9);
}

TEST(RobotEnvironment, ContactsAreKnownBeforeTheFirstStep) {
  Stage stage;
  stage.environment.StartEpisode();
  const bool* contact = stage.Read("contact").flags();
  for (int i = 0; i < 18; ++i) EXPECT_EQ(contact[i], i == 12 || i == 17) << i;
}

TEST(RobotEnvironment, TargetsAreReadAfterTheStartOfATimeStepAndHeld) {
  Stage stage;
  stage.environment.StartEpisode();
  stage.listener.when_time_step_starts = [&] { stage.listener.targets[8] = 0.1; };
  std::vector<double> torques;
  stage.listener.when_physics_step_ends = [&] {
    torques.push_back(stage.Real("joint.torque", 8));
    stage.listener.targets[8] = -0.1;  // not before the next time step
  };
  stage.environment.RunTimeStep();
  EXPECT_EQ(torques.front(), 2.5 * 0.1);
  for (const double torque : torques) EXPECT_GT(torque, 0);
}

TEST(RobotEnvironment, HoldsAllJointsAtZeroWhileNothingDrivesIt) {
  RobotEnvironment environment("environment", Context{&Humanoid(), {}, 0});
  environment.Start();
  environment.StartEpisode();
  for (int i = 0; i < 20; ++i) environment.RunTimeStep();
  EXPECT_NEAR(static_cast<SensorOut&>(environment.FindPort("base.position"))().reals()[2], 0.2421,
              1e-4);
}

TEST(RobotEnvironment, SensorPortsTellTypeAndUnit) {
  Stage stage;
  EXPECT_EQ(stage.environment.FindPort("base.velocity").type().text, "vec3 [m/s]");
  EXPECT_EQ(stage.environment.FindPort("base.orientation").type().text, "quat");
  EXPECT_EQ(stage.environment.FindPort("joint.torque").type().text, "real[joint] [N m]");
  EXPECT_EQ(stage.environment.FindPort("contact").type().text, "bool[link]");
}

TEST(RobotEnvironment, PoseIsPositionAndOrientationOfEveryLink) {
  Stage stage(Humanoid(), "paper", "lying");
  stage.environment.StartEpisode();
  std::vector<float> pose(7 * 18);
  stage.environment.CapturePose(pose);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(pose[i], static_cast<float>(stage.Real("base.position", i)));
  }
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(pose[3 + i], static_cast<float>(stage.Real("base.orientation", i)));
  }
  EXPECT_GT(pose[7 * 1], pose[0]);  // the head lies in front of the body
}

TEST(RobotEnvironment, WrongParametersAreRefused) {
  RobotEnvironment environment("environment", Context{&Humanoid(), {}, 0});
  EXPECT_THROW(environment.Set("profile", std::string("papper")), UserError);
  EXPECT_THROW(environment.Set("start_pose", std::string("laying")), UserError);
}

// A robot whose controller is far beyond what its step can hold.
robot::RobotDescription Unstable() {
  robot::RobotDescription robot = Humanoid();
  robot.controller.stiffness = 1e5;
  robot.controller.damping = 1e3;
  robot.controller.max_torque = 1e9;
  return robot;
}

TEST(RobotEnvironment, ADivergingSimulationEndsTheEpisode) {
  const robot::RobotDescription robot = Unstable();
  Stage stage(robot);
  stage.listener.targets.setConstant(0.1);
  stage.environment.StartEpisode();
  stage.listener.when_time_step_starts = [&] { stage.Real("base.position"); };
  for (int i = 0; i < 100 && stage.listener.end_reason.empty(); ++i) {
    stage.environment.RunTimeStep();
  }
  EXPECT_EQ(stage.listener.events.back(), "diverged");
  EXPECT_THAT(stage.listener.end_reason, HasSubstr("the simulation diverged: "));
  // Nothing happens until the next episode, and what can be seen is finite.
  const size_t events = stage.listener.events.size();
  stage.environment.RunTimeStep();
  EXPECT_EQ(stage.listener.events.size(), events);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(std::isfinite(stage.Real("base.position", i)));
  EXPECT_TRUE(std::isfinite(stage.Real("joint.angle", 3)));
  std::vector<float> pose(7 * 18);
  stage.environment.CapturePose(pose);
  for (const float number : pose) EXPECT_TRUE(std::isfinite(number));
}

// What a peek reads is what everybody reads, and a diverged episode shows what was read before it.
TEST(RobotEnvironment, APeekLeavesNoTrace) {
  Stage stage;
  stage.environment.StartEpisode();
  stage.environment.RunTimeStep();
  const double before = stage.Real("base.position", 2);
  stage.environment.RunTimeStep();
  double peeked = 0;
  {
    const RobotEnvironment::Peek peek(stage.environment);
    peeked = stage.Real("base.position", 2);
  }
  std::vector<float> pose(7 * 18);
  stage.environment.CapturePose(pose);
  EXPECT_NE(peeked, before);
  EXPECT_EQ(static_cast<float>(peeked), pose[2]);
  stage.listener.targets[3] = std::numeric_limits<double>::quiet_NaN();
  stage.environment.RunTimeStep();
  ASSERT_EQ(stage.listener.events.back(), "diverged");
  EXPECT_EQ(stage.Real("base.position", 2), before);
}

TEST(RobotEnvironment, WhatIsReadAfterAPeekCounts) {
  Stage stage;
  stage.environment.StartEpisode();
  stage.environment.RunTimeStep();
  {
    const RobotEnvironment::Peek peek(stage.environment);
    stage.Real("base.position", 2);
  }
  const double read = stage.Real("base.position", 2);
  stage.listener.targets[3] = std::numeric_limits<double>::quiet_NaN();
  stage.environment.RunTimeStep();
  EXPECT_EQ(stage.Real("base.position", 2), read);
}

TEST(RobotEnvironment, CapturesWhatTheContactSensorSays) {
  Stage stage;
  stage.environment.StartEpisode();
  for (int i = 0; i < 100; ++i) stage.environment.RunTimeStep();
  std::vector<uint8_t> contacts(3);
  stage.environment.CaptureContacts(contacts);
  int touching = 0;
  for (int link = 0; link < 18; ++link) {
    const bool touches = (contacts[link / 8] >> link % 8 & 1) != 0;
    EXPECT_EQ(touches, stage.Read("contact").flags()[link]) << link;
    touching += touches;
  }
  EXPECT_GT(touching, 0);
}

TEST(RobotEnvironment, TheNextEpisodeAfterADivergedOneRuns) {
  Stage stage;
  stage.environment.StartEpisode();
  stage.listener.targets[3] = std::numeric_limits<double>::quiet_NaN();
  stage.environment.RunTimeStep();
  EXPECT_EQ(stage.listener.events.back(), "diverged");
  stage.listener.targets.setZero();
  stage.environment.StartEpisode();
  stage.listener.events.clear();
  stage.environment.RunTimeStep();
  EXPECT_EQ(stage.listener.events, TimeStep(25));
  EXPECT_NEAR(stage.Real("base.position", 2), 0.2421, 1e-4);
}

TEST(RobotEnvironment, NothingHappensBeforeTheFirstEpisode) {
  Stage stage;
  stage.environment.RunTimeStep();
  EXPECT_TRUE(stage.listener.events.empty());
}

}  // namespace
}  // namespace runtime
