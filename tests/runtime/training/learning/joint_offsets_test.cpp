#include "runtime/training/learning/joint_offsets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runtime/training/learning/fake_sensors.h"
#include "tests/runtime/training/learning/fake_state.h"
#include "tests/runtime/training/learning/time_step.h"
#include "tests/runtime/training/learning/user_error_of.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// Gives vectors to an action space, and hears of the ends of its actions.
class VectorCommander : public Module {
 public:
  VectorCommander() : Module("commander") {}

  Signal<const Eigen::VectorXd&> execute{this, "execute"};
  Signal<double> start_of_time_step{this, "start_of_time_step"};
  Signal<double> end_of_time_step{this, "end_of_time_step"};
  In<Eigen::VectorXd> joint_targets{this, "joint_targets"};
  In<int> action_size{this, "action_size"};
  int ended = 0;

 private:
  void EndOfAction() { ++ended; }
  Slot<> end_of_action_{this, "end_of_action", Bind<&VectorCommander::EndOfAction>{}};
};

class JointOffsetsTest : public testing::Test {
 protected:
  explicit JointOffsetsTest(const robot::RobotDescription& robot = Humanoid())
      : offsets_("action_space", {.robot = &robot, .task = {}, .seed = 1}) {
    for (const char* port : {"execute", "end_of_time_step"}) {
      Connect(commander_, port, offsets_, port);
    }
    for (const char* port : {"joint_targets", "action_size", "end_of_action"}) {
      Connect(offsets_, port, commander_, port);
    }
  }
  void Use(const std::string& dof) {
    offsets_.Set("dof", dof);
    offsets_.Start();
  }
  // Where a joint is told to go.
  double TargetOf(const char* joint) const {
    return commander_.joint_targets()[*Humanoid().FindJoint(joint)];
  }

  VectorCommander commander_;
  JointOffsets offsets_;
};

TEST_F(JointOffsetsTest, MovesTheJointsOfADofConfiguration) {
  Use("6");
  ASSERT_EQ(commander_.action_size(), 6);
  EXPECT_TRUE(commander_.joint_targets().isZero(0));  // at rest
  Eigen::VectorXd action(6);
  action << 0.1, 0.2, -0.3, 0.4, -0.5, 0.6;
  commander_.execute(action);
  EXPECT_EQ(TargetOf("left_shoulder_pitch"), 0.1);
  EXPECT_EQ(TargetOf("right_shoulder_pitch"), 0.1);
  EXPECT_EQ(TargetOf("left_hip_roll"), -0.3);
  EXPECT_EQ(TargetOf("right_hip_roll"), 0.3);
  EXPECT_EQ(TargetOf("right_ankle_pitch"), 0.6);
  EXPECT_EQ(TargetOf("neck_yaw"), 0);
}

TEST_F(JointOffsetsTest, MovesEachJointByItself) {
  Use("all");
  ASSERT_EQ(commander_.action_size(), 17);
  commander_.execute(Eigen::VectorXd::LinSpaced(17, -0.08, 0.08));
  EXPECT_EQ(TargetOf("neck_yaw"), -0.08);
  EXPECT_EQ(TargetOf("right_ankle_roll"), 0.08);
}

TEST_F(JointOffsetsTest, ScalesActionsAndStopsAtTheStops) {
  offsets_.Set("scale", 0.5);
  Use("5");
  Eigen::VectorXd action(5);
  action << 0.5, 100, 0, -100, 0;
  commander_.execute(action);
  EXPECT_EQ(TargetOf("left_shoulder_pitch"), 0.25);
  EXPECT_EQ(TargetOf("left_elbow_pitch"), Humanoid().joints[3].high);
  EXPECT_EQ(TargetOf("left_knee_pitch"), Humanoid().joints[9].low);
}

TEST_F(JointOffsetsTest, HoldsTargetsForSomeTimeSteps) {
  offsets_.Set("hold", int64_t{3});
  Use("5");
  commander_.end_of_time_step(kTimeStep);  // nothing runs yet
  commander_.execute(Eigen::VectorXd::Constant(5, 0.1));
  for (int step = 0; step < 2; ++step) commander_.end_of_time_step(kTimeStep);
  EXPECT_EQ(commander_.ended, 0);
  commander_.end_of_time_step(kTimeStep);
  EXPECT_EQ(commander_.ended, 1);
  commander_.end_of_time_step(kTimeStep);
  EXPECT_EQ(commander_.ended, 1);
  EXPECT_EQ(TargetOf("left_hip_pitch"), 0.1);
}

TEST_F(JointOffsetsTest, AnActionOfAnotherSizeIsRefused) {
  Use("5");
  EXPECT_THAT(UserErrorOf([&] { commander_.execute(Eigen::VectorXd::Zero(4)); }),
              AllOf(HasSubstr("`action_space` gets an action of 4 elements"), HasSubstr("have 5")));
}

TEST_F(JointOffsetsTest, AnUnknownDofConfigurationIsRefused) {
  EXPECT_THAT(UserErrorOf([&] { Use("al"); }),
              AllOf(HasSubstr("`action_space.dof`: the robot `humanoid`"), HasSubstr("`all`")));
}

// Of which the first pose is another one.
robot::RobotDescription Crouching() {
  robot::RobotDescription robot = Humanoid();
  robot.poses.front().joint_angles.assign(17, 0.05);
  return robot;
}

class CrouchingJointOffsetsTest : public JointOffsetsTest {
 protected:
  CrouchingJointOffsetsTest() : JointOffsetsTest(Robot()) {}
  static const robot::RobotDescription& Robot() {
    static const robot::RobotDescription robot = Crouching();
    return robot;
  }
};

TEST_F(CrouchingJointOffsetsTest, OffsetsAreFromTheRestPose) {
  Use("5");
  EXPECT_EQ(TargetOf("neck_yaw"), 0.05);
  commander_.execute(Eigen::VectorXd::Constant(5, 0.1));
  EXPECT_NEAR(TargetOf("left_hip_pitch"), 0.15, 1e-15);
  EXPECT_EQ(TargetOf("neck_yaw"), 0.05);
}

TEST_F(CrouchingJointOffsetsTest, SaysWhatItDoesWithAnAction) {
  offsets_.Set("scale", 0.5);
  offsets_.Set("hold", int64_t{3});
  Use("5");
  PolicyGraph graph;
  EXPECT_EQ(offsets_.AddTo(graph, PolicyGraph::kObservation), 2u);
  EXPECT_EQ(graph.time_steps, 3);
  EXPECT_EQ(graph.others.at(0).name, "action");
  EXPECT_EQ(graph.others.at(0).elements.at(0).name, "left_shoulder_pitch");
  const auto& offsets = std::get<PolicyGraph::Affine>(graph.steps.at(0));
  const int shoulder = *Humanoid().FindJoint("right_shoulder_pitch");
  EXPECT_EQ(offsets.factors(shoulder, 0), 0.5f);
  EXPECT_EQ(offsets.offsets[shoulder], 0.05f);
  EXPECT_EQ(offsets.factors.row(*Humanoid().FindJoint("neck_yaw")).norm(), 0);
  const auto& stops = std::get<PolicyGraph::Clamp>(graph.steps.at(1));
  EXPECT_EQ(stops.high[shoulder], static_cast<float>(Humanoid().joints[shoulder].high));
}

// Where the joints are to go without offsets.
class MovingPose : public Module {
 public:
  MovingPose() : Module("motion") {}

  Eigen::VectorXd targets = Eigen::VectorXd::Zero(17);
  Out<Eigen::VectorXd> joint_targets{this, "joint_targets", &targets};
};

TEST_F(JointOffsetsTest, OffsetsAreFromAMotionInEachTimeStep) {
  MovingPose motion;
  Port::Connect(motion.joint_targets, offsets_.FindPort("motion"));
  Signal<double>& start = commander_.start_of_time_step;
  Port::Connect(start, offsets_.FindPort("start_of_time_step"));
  Use("5");
  commander_.execute(Eigen::VectorXd{{0.25, 0, 0, 0, 0}});
  const size_t shoulder = *Humanoid().FindJoint("left_shoulder_pitch");
  const size_t neck = *Humanoid().FindJoint("neck_yaw");
  for (const double place : {0.5, -0.5}) {
    motion.targets[shoulder] = place;
    motion.targets[neck] = 0.125;
    start(kTimeStep);
    EXPECT_EQ(TargetOf("left_shoulder_pitch"), place + 0.25);
    EXPECT_EQ(TargetOf("neck_yaw"), 0.125);
  }
  motion.targets[shoulder] = 100;  // beyond its stop
  start(kTimeStep);
  EXPECT_EQ(TargetOf("left_shoulder_pitch"), Humanoid().joints[shoulder].high);
  PolicyGraph graph;
  EXPECT_THAT(UserErrorOf([&] { offsets_.AddTo(graph, PolicyGraph::kObservation); }),
              HasSubstr("`action_space.motion` is connected"));
}

// Whose neck can turn all the way around.
class WheelOffsetsTest : public JointOffsetsTest {
 protected:
  WheelOffsetsTest() : JointOffsetsTest(Robot()) {
    Port::Connect(environment_.FindPort("joint.angle"), offsets_.FindPort("joint.angle"));
  }
  static const robot::RobotDescription& Robot() {
    static const robot::RobotDescription robot = [] {
      robot::RobotDescription owl = Humanoid();
      robot::Joint& neck = owl.joints[*owl.FindJoint("neck_yaw")];
      neck.kind = robot::JointKind::kContinuous;
      neck.low = -robot::kUnlimited;
      neck.high = robot::kUnlimited;
      return owl;
    }();
    return robot;
  }
  FakeSensors sensors_;
  FakeSensorModule environment_{&sensors_};
};

TEST_F(WheelOffsetsTest, AJointWithoutStopsIsMovedFromWhereItIs) {
  Use("all");
  double& angle = sensors_.joint_angle[*Humanoid().FindJoint("neck_yaw")];
  angle = 40;
  commander_.execute(Eigen::VectorXd::Constant(17, 0.5));
  EXPECT_EQ(TargetOf("neck_yaw"), 40.5);
  EXPECT_EQ(TargetOf("left_knee_pitch"), Humanoid().joints[9].high);
  angle = 40.25;
  commander_.end_of_time_step(kTimeStep);
  EXPECT_EQ(TargetOf("neck_yaw"), 40.75);
  EXPECT_EQ(TargetOf("left_hip_pitch"), 0.5);
  PolicyGraph graph;
  EXPECT_THAT(UserErrorOf([&] { offsets_.AddTo(graph, PolicyGraph::kObservation); }),
              HasSubstr("the target of `neck_yaw`, a joint without stops, follows its angle"));
}

}  // namespace
}  // namespace runtime
