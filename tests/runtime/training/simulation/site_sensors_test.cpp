// Sensors of sites, against what follows from the motion of their links, from theory, and from each
// other.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>

#include "plugins/robot/rotation.h"
#include "runtime/training/simulation/robot_environment.h"
#include "tests/runtime/training/simulation/robots.h"

namespace runtime {
namespace {

using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
using Eigen::Vector3d;

Vector3d ToVector(const robot::Vector3& v) { return {v[0], v[1], v[2]}; }

// By the formula of the matrix, not by products of quaternions.
RowMajor MatrixOf(const double* q) {
  return RowMajor(robot::RotationMatrix({q[0], q[1], q[2], q[3]}).data());
}

// A world whose sensors are read after each physics step.
class Sensed {
 public:
  Sensed(const robot::RobotDescription& robot, const char* profile, const robot::StartState& start)
      : world_(robot, FindProfile(profile), start), sensors_(robot, nullptr) {
    for (RobotSensor& sensor : sensors_.sensors()) by_name_[sensor.description().name] = &sensor;
    sensors_.Refresh(world_, 0);
  }

  void StartTimeStep() { world_.StartTimeStep({.site_accelerations = true}); }
  void Step(const std::vector<double>& targets) {
    world_.Step(targets);
    sensors_.Refresh(world_, 0);
  }
  double step() const { return world_.physics_time_step(); }

  Vector3d Vector(const char* sensor, int entry) {
    return Vector3d(by_name_.at(sensor)->Read().reals() + 3 * entry);
  }
  RowMajor Turn(const char* sensor, int entry) {
    return MatrixOf(by_name_.at(sensor)->Read().reals() + 4 * entry);
  }

 private:
  World world_;
  RobotSensors sensors_;
  std::map<std::string_view, RobotSensor*> by_name_;
};

class SiteSensorsTest : public testing::TestWithParam<const char*> {
 protected:
  // The robot with every kind of joint, in the middle of a motion.
  SiteSensorsTest() : sensed_(Tinker(), GetParam(), robot::RestIn(Tinker().poses[1])) {
    for (int i = 0; i < 40; ++i) Step();
  }

  void Step() { sensed_.Step({3.5, -0.2, 12}); }
  static int count() { return static_cast<int>(Tinker().sites.size()); }
  static const robot::Site& site(int index) { return Tinker().sites[static_cast<size_t>(index)]; }
  // From the center of its link, in the zero pose, in which links are parallel to the world.
  static Vector3d Arm(int index) {
    const robot::Link& link = Tinker().links[static_cast<size_t>(site(index).link)];
    return ToVector(site(index).position) - ToVector(link.position);
  }

  Sensed sensed_;
};

TEST_P(SiteSensorsTest, AreFixedToTheirLinks) {
  for (int i = 0; i < count(); ++i) {
    const int link = site(i).link;
    const RowMajor turn = sensed_.Turn("link.orientation", link);
    const Vector3d arm = turn * Arm(i);
    EXPECT_GT((arm - Arm(i)).norm(), 1e-3) << "not turned: " << site(i).name;
    EXPECT_NEAR(
        (sensed_.Vector("site.position", i) - sensed_.Vector("link.position", link) - arm).norm(),
        0, 1e-12)
        << site(i).name;
    const Vector3d rotation = sensed_.Vector("link.angular_velocity", link);
    EXPECT_EQ(sensed_.Vector("site.angular_velocity", i), rotation) << site(i).name;
    EXPECT_NEAR((sensed_.Vector("site.velocity", i) - sensed_.Vector("link.velocity", link) -
                 rotation.cross(arm))
                    .norm(),
                0, 1e-10)
        << site(i).name;
    const RowMajor expected = turn * MatrixOf(site(i).orientation.data());
    EXPECT_NEAR((sensed_.Turn("site.orientation", i) - expected).norm(), 0, 1e-10) << site(i).name;
  }
}

// A physics step moves a site on an arc, whose chord is the mean of the velocities at both ends but
// for what is of third order.
TEST_P(SiteSensorsTest, MoveByTheirVelocities) {
  const double h = sensed_.step();
  double fastest = 0;
  for (int step = 0; step < 5; ++step) {
    std::vector<Vector3d> places, rotations;
    std::vector<RowMajor> turns;
    for (int i = 0; i < count(); ++i) {
      places.push_back(sensed_.Vector("site.position", i));
      turns.push_back(sensed_.Turn("site.orientation", i));
    }
    Step();
    for (int i = 0; i < count(); ++i) {
      const auto entry = static_cast<size_t>(i);
      const Vector3d velocity = sensed_.Vector("site.velocity", i);
      const Vector3d rotation = sensed_.Vector("site.angular_velocity", i);
      const Vector3d moved = (sensed_.Vector("site.position", i) - places[entry]) / h;
      const double bend = h * rotation.squaredNorm() * Arm(i).norm();
      EXPECT_NEAR((moved - velocity).norm(), 0, bend + 0.02 * (1 + velocity.norm()))
          << site(i).name;
      const Eigen::AngleAxisd turn(
          Eigen::Matrix3d(sensed_.Turn("site.orientation", i) * turns[entry].transpose()));
      EXPECT_NEAR((turn.angle() / h * turn.axis() - rotation).norm(), 0,
                  0.02 * (1 + rotation.norm()))
          << site(i).name;
      fastest = std::max(fastest, velocity.norm());
    }
  }
  EXPECT_GT(fastest, 0.3);
}

TEST_P(SiteSensorsTest, AccelerationsAreMeansOfTheTimeStep) {
  std::vector<Vector3d> before;
  for (int i = 0; i < count(); ++i) before.push_back(sensed_.Vector("site.velocity", i));
  sensed_.StartTimeStep();
  for (int step = 0; step < 4; ++step) Step();
  for (int i = 0; i < count(); ++i) {
    const Vector3d change = sensed_.Vector("site.velocity", i) - before[static_cast<size_t>(i)];
    const Vector3d felt = change / (4 * sensed_.step()) + Vector3d(0, 0, robot::kGravity);
    const Vector3d in_site = sensed_.Turn("site.orientation", i).transpose() * felt;
    EXPECT_NEAR((sensed_.Vector("site.acceleration", i) - in_site).norm(), 0,
                1e-9 * (1 + felt.norm()))
        << site(i).name;
  }
}

// Two balls on an axle fall and spin: on the rim of one, an accelerometer shows what bends its
// path, and nothing of the fall.
TEST_P(SiteSensorsTest, OnASpinningWheelTheAccelerationIsCentripetal) {
  constexpr double kRate = 20;     // [rad/s]
  constexpr double kRadius = 0.3;  // [m]
  robot::RobotDescription robot = Rotor();
  robot.sites = {{.name = "center", .link = 1},
                 {.name = "rim", .link = 1, .position = {kRadius, 0, 0}}};
  robot.joints[0].kind = robot::JointKind::kContinuous;
  robot.joints[0].low = -robot::kUnlimited;
  robot.joints[0].high = robot::kUnlimited;
  robot.joints[0].gains = {.stiffness = 0, .damping = 0, .max_torque = 0, .max_speed = {}};
  robot::StartState start = robot::RestIn(robot.poses[0]);
  start.angular_velocity = {0, 0, kRate};
  Sensed sensed(robot, GetParam(), start);
  for (int i = 0; i < 10; ++i) sensed.Step({0});
  sensed.StartTimeStep();
  for (int i = 0; i < 2; ++i) sensed.Step({0});
  EXPECT_NEAR(sensed.Vector("site.acceleration", 0).norm(), 0, 1e-3);
  EXPECT_NEAR(sensed.Vector("site.velocity", 1).head<2>().norm(), kRate * kRadius, 1e-2);
  // The mean over an arc is that at its middle, by which the axes have turned since.
  const Vector3d felt = sensed.Vector("site.acceleration", 1);
  EXPECT_NEAR(felt.norm(), kRate * kRate * kRadius, 0.01 * kRate * kRate * kRadius);
  EXPECT_LT(felt.x(), -0.98 * felt.norm());
}

// The soles of a humanoid that stands are on the ground, and its head is as tall as it is.
TEST_P(SiteSensorsTest, OfTheHumanoidAreWhereTheyAreCalled) {
  Sensed sensed(Humanoid(), GetParam(), robot::RestIn(Humanoid().poses[0]));
  std::map<std::string, Vector3d> places;
  for (size_t i = 0; i < Humanoid().sites.size(); ++i)
    places[Humanoid().sites[i].name] = sensed.Vector("site.position", static_cast<int>(i));
  for (const char* name : {"left_toe", "left_heel", "right_toe", "right_heel"})
    EXPECT_NEAR(places.at(name).z(), 0, 1e-5) << name;
  EXPECT_NEAR((places.at("left_toe") - places.at("left_heel")).norm(), 0.1, 1e-12);
  EXPECT_NEAR(places.at("head_top").z(), 0.328, 0.001);
  EXPECT_NEAR(places.at("left_hand_tip").y(), -places.at("right_hand_tip").y(), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Profiles, SiteSensorsTest, testing::ValuesIn(BuiltProfiles()),
                         ProfileInName);

class SitesOfEnvironmentTest : public testing::TestWithParam<const char*> {
 protected:
  // Reads `sensor` of a standing humanoid after a while.
  std::vector<double> Read(const robot::RobotDescription& robot, const char* sensor) {
    RobotEnvironment environment("environment", {&robot, {}, 0});
    environment.Set("profile", std::string(GetParam()));
    Module reader("reader");
    Port& out = environment.FindPort(sensor);
    SensorIn in(&reader, sensor, out.type().text);
    Port::Connect(out, in);
    environment.Start();
    environment.StartEpisode();
    for (int i = 0; i < 60; ++i) environment.RunTimeStep();
    const robot::SensorDescription& description = *robot::FindSensor(sensor);
    const double* values = in().reals();
    return {values, values + robot::ElementCount(description, robot)};
  }
};

// It is measured where a task is connected to it: standing, each shows gravity along its own axes.
TEST_P(SitesOfEnvironmentTest, AccelerometersShowGravityAlongTheirAxes) {
  robot::RobotDescription robot = Humanoid();
  robot.sites[0].orientation = {0, 1, 0, 0};                            // head down
  robot.sites[3].orientation = {std::sqrt(0.5), std::sqrt(0.5), 0, 0};  // y is up
  const std::vector<double> felt = Read(robot, "site.acceleration");
  EXPECT_NEAR(felt[2], -robot::kGravity, 0.6);
  EXPECT_NEAR(felt[3 * 3 + 1], robot::kGravity, 0.6);
  EXPECT_NEAR(felt[3 * 4 + 2], robot::kGravity, 0.6);
}

TEST_P(SitesOfEnvironmentTest, WithoutSitesThereAreNoSuchPorts) {
  RobotEnvironment environment("environment", {&Hopper(), {}, 0});
  for (const Port* port : environment.ports())
    EXPECT_FALSE(port->name().starts_with("site")) << port->name();
}

TEST_P(SitesOfEnvironmentTest, SitesAndTheirSensorsChangeNoMotion) {
  robot::RobotDescription without = Humanoid();
  without.sites.clear();
  without.site_groups.clear();
  EXPECT_EQ(Read(without, "link.velocity"), Read(Humanoid(), "link.velocity"));
}

INSTANTIATE_TEST_SUITE_P(Profiles, SitesOfEnvironmentTest, testing::ValuesIn(BuiltProfiles()),
                         ProfileInName);

}  // namespace
}  // namespace runtime
