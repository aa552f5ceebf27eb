// Sensors of all links, of accelerations and of forces, against what follows from the others.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <random>

#include "runtime/training/simulation/robot_environment.h"
#include "tests/runtime/training/simulation/robots.h"

namespace runtime {
namespace {

// Reads some sensors at the end of every time step; moves the robot at random, or holds it.
class Reader : public Module {
 public:
  Reader(RobotEnvironment& environment, const std::vector<std::string>& sensors)
      : Module("reader") {
    targets_.setZero(static_cast<Eigen::Index>(Humanoid().joints.size()));
    for (const std::string& name : sensors) {
      Port& out = environment.FindPort(name);
      SensorIn& in = *(ports_[name] = std::make_unique<SensorIn>(this, name, out.type().text));
      Port::Connect(out, in);
    }
    Port::Connect(environment.FindPort("joint_targets"), joint_targets_);
  }

  Eigen::Map<const Eigen::VectorXd> Read(const std::string& name, int count) const {
    return {(*ports_.at(name))().reals(), count};
  }
  Eigen::Map<const Eigen::Matrix<double, 3, Eigen::Dynamic>> Vectors(
      const std::string& name) const {
    return {(*ports_.at(name))().reals(), 3, static_cast<Eigen::Index>(Humanoid().links.size())};
  }

  // New targets ten times a second.
  void Move() {
    if (steps_++ % 20 != 0) return;
    for (double& target : targets_) {
      target = std::uniform_real_distribution<double>(-0.8, 0.8)(random_);
    }
  }
  const Eigen::VectorXd& targets() const { return targets_; }

 private:
  Eigen::VectorXd targets_;
  Out<Eigen::VectorXd> joint_targets_{this, "joint_targets", &targets_};
  std::mt19937 random_{3};
  int steps_ = 0;
  std::map<std::string, std::unique_ptr<SensorIn>> ports_;
};

const std::vector<std::string> kAll = {
    "base.velocity", "base.rotation",    "base.acceleration",     "joint.velocity",
    "joint.target",  "joint.angle",      "joint.acceleration",    "link.position",
    "link.velocity", "link.orientation", "link.angular_velocity", "contact_force"};

class MotionSensorsTest : public testing::TestWithParam<const char*> {
 protected:
  MotionSensorsTest() : environment_("environment", {&Humanoid(), {}, 0}) {
    environment_.Set("profile", std::string(GetParam()));
    environment_.Start();
  }

  void Start(const char* pose, const std::vector<std::string>& sensors = kAll) {
    reader_.emplace(environment_, sensors);
    environment_.Set("start_pose", std::string(pose));
    environment_.StartEpisode();
  }
  void Run(int time_steps, bool moves) {
    for (int i = 0; i < time_steps; ++i) {
      if (moves) reader_->Move();
      environment_.RunTimeStep();
    }
  }

  static double mass(int link) { return Humanoid().links[static_cast<size_t>(link)].mass; }
  Eigen::Vector3d Momentum() const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    const auto velocities = reader_->Vectors("link.velocity");
    for (int i = 0; i < velocities.cols(); ++i) sum += mass(i) * velocities.col(i);
    return sum;
  }
  static double Weight() {
    double sum = 0;
    for (const robot::Link& link : Humanoid().links) sum += link.mass;
    return sum * robot::kGravity;
  }

  static constexpr double kTimeStep = 0.005;

  RobotEnvironment environment_;
  std::optional<Reader> reader_;
};

// The force of gravity is not among them, and those between two links cancel each other.
TEST_P(MotionSensorsTest, ContactForcesAreWhatChangesTheMomentum) {
  Start("lying");
  int with_force = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d before = i == 0 ? Eigen::Vector3d::Zero().eval() : Momentum();
    Run(1, true);
    const Eigen::Vector3d forces = reader_->Vectors("contact_force").rowwise().sum();
    const Eigen::Vector3d change = (Momentum() - before) / kTimeStep;
    const Eigen::Vector3d difference = forces - change - Eigen::Vector3d(0, 0, Weight());
    sum += difference;
    // MuJoCo's links are where their joints are after a step, so that their momentum is not quite
    // what the step gave them; on average it is.
    EXPECT_NEAR(difference.norm(), 0, IsMujoco(GetParam()) ? 0.3 * Weight() : 1e-6) << i;
    with_force += forces.norm() > 1;
  }
  EXPECT_NEAR(sum.norm() / 100, 0, 0.01 * Weight());
  EXPECT_GT(with_force, 50);
}

TEST_P(MotionSensorsTest, StandingRobotHasItsWeightOnItsFeet) {
  Start("standing");
  Run(60, false);
  const auto forces = reader_->Vectors("contact_force");
  Eigen::Vector3d feet = Eigen::Vector3d::Zero();
  for (const char* foot : {"left_foot", "right_foot"}) {
    feet += forces.col(Humanoid().FindLink(foot).value());
  }
  EXPECT_NEAR(feet.z(), Weight(), 0.1 * Weight());
  EXPECT_NEAR((forces.rowwise().sum() - feet).norm(), 0, 1e-12);
  EXPECT_NEAR(forces(2, Humanoid().FindLink("left_foot").value()), Weight() / 2, 0.1 * Weight());
  // It is held up as if it were pushed up by what it weighs.
  EXPECT_NEAR(reader_->Read("base.acceleration", 3)[2], robot::kGravity, 0.5);
}

TEST_P(MotionSensorsTest, LinksMoveByTheirVelocities) {
  World world(Humanoid(), FindProfile(GetParam()), Humanoid().poses[1]);
  RobotSensors sensors(Humanoid(), nullptr);
  std::map<std::string_view, RobotSensor*> by_name;
  for (RobotSensor& sensor : sensors.sensors()) by_name[sensor.description().name] = &sensor;
  std::vector<double> targets(Humanoid().joints.size(), 0.4);
  StepFor(world, 0.1, targets);
  sensors.Refresh(world, 0);
  using Links = Eigen::Map<const Eigen::Matrix<double, 3, 18>>;
  const Eigen::Matrix<double, 3, 18> before = Links(by_name["link.position"]->Read().reals());
  const Eigen::Matrix<double, 4, 18> turned =
      Eigen::Map<const Eigen::Matrix<double, 4, 18>>(by_name["link.orientation"]->Read().reals());
  world.Step(targets);
  sensors.Refresh(world, 0);
  const double h = world.physics_time_step();
  const Links after(by_name["link.position"]->Read().reals());
  const Links velocity(by_name["link.velocity"]->Read().reals());
  // Positions are moved by the new velocities; MuJoCo's joints, by which their links go on circles.
  EXPECT_NEAR(((after - before) / h - velocity).norm(), 0, IsMujoco(GetParam()) ? 0.01 : 1e-9);
  const Links rotation(by_name["link.angular_velocity"]->Read().reals());
  const double* now = by_name["link.orientation"]->Read().reals();
  for (int i = 0; i < 18; ++i) {
    const auto of = [](const auto& q) { return Eigen::Quaterniond(q[0], q[1], q[2], q[3]); };
    const Eigen::AngleAxisd turn(of(now + 4 * i) * of(turned.col(i)).inverse());
    const Eigen::Vector3d mean = turn.angle() / h * turn.axis();
    EXPECT_NEAR((mean - rotation.col(i)).norm(), 0, 1e-2 * (1 + rotation.col(i).norm())) << i;
  }
}

TEST_P(MotionSensorsTest, AccelerationsAreMeansOfTheTimeStep) {
  Start("lying");
  Run(20, true);
  for (int i = 0; i < 20; ++i) {
    const Eigen::VectorXd joints = reader_->Read("joint.velocity", 17);
    const Eigen::Vector3d base = reader_->Read("base.velocity", 3);
    Run(1, true);
    EXPECT_NEAR((reader_->Read("joint.acceleration", 17) -
                 (reader_->Read("joint.velocity", 17) - joints) / kTimeStep)
                    .norm(),
                0, 1e-9);
    const Eigen::Vector3d felt = (reader_->Read("base.velocity", 3) - base) / kTimeStep +
                                 Eigen::Vector3d(0, 0, robot::kGravity);
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> rotation(
        reader_->Read("base.rotation", 9).data());
    EXPECT_NEAR((rotation * reader_->Read("base.acceleration", 3) - felt).norm(), 0, 1e-9);
  }
}

TEST_P(MotionSensorsTest, TargetsAreThoseOfTheLastPhysicsStep) {
  Start("lying");
  EXPECT_EQ(reader_->Read("joint.target", 17), Eigen::VectorXd::Zero(17));
  Run(1, true);
  EXPECT_EQ(reader_->Read("joint.target", 17), reader_->targets());
}

TEST_P(MotionSensorsTest, AtTheStartNothingAccelerates) {
  Start("standing");
  EXPECT_EQ(reader_->Read("base.acceleration", 3), Eigen::Vector3d(0, 0, robot::kGravity));
  EXPECT_EQ(reader_->Read("joint.acceleration", 17), Eigen::VectorXd::Zero(17));
  EXPECT_EQ(reader_->Vectors("contact_force").norm(), 0);
}

// Reading them measures, but does not disturb.
TEST_P(MotionSensorsTest, ChangeNothing) {
  Start("lying");
  Run(100, true);
  const Eigen::VectorXd with = reader_->Read("joint.angle", 17);
  reader_.reset();
  Start("lying", {"joint.angle"});
  Run(100, true);
  EXPECT_EQ(reader_->Read("joint.angle", 17), with);
}

INSTANTIATE_TEST_SUITE_P(Profiles, MotionSensorsTest, testing::ValuesIn(BuiltProfiles()),
                         ProfileInName);

}  // namespace
}  // namespace runtime
