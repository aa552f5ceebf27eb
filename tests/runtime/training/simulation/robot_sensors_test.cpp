#include "runtime/training/simulation/robot_sensors.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>

#include "tests/runtime/training/simulation/robots.h"

namespace runtime {
namespace {

// Every sensor of a robot that is in the middle of a motion.
class RobotSensorsTest : public testing::Test {
 protected:
  RobotSensorsTest()
      : world_(Humanoid(), FindProfile("paper"), Humanoid().poses[1]),
        sensors_(Humanoid(), nullptr) {
    for (RobotSensor& sensor : sensors_.sensors()) by_name_[sensor.description().name] = &sensor;
    Move();
    sensors_.Refresh(world_, 0.25);
  }

  void Move() {
    std::vector<double> targets = Zeros(Humanoid());
    for (size_t j = 0; j < targets.size(); ++j) targets[j] = j % 2 == 0 ? 0.3 : -0.2;
    StepFor(world_, 0.05, targets);
  }
  const double* Reals(std::string_view name) { return by_name_.at(name)->Read().reals(); }
  dBodyID base() const { return world_.body().body(0); }
  void ExpectReals(std::string_view name, const dReal* expected, int count) {
    for (int i = 0; i < count; ++i) EXPECT_EQ(Reals(name)[i], expected[i]) << name << " " << i;
  }

  World world_;
  RobotSensors sensors_;
  std::map<std::string_view, RobotSensor*> by_name_;
};

TEST_F(RobotSensorsTest, ThereIsOneForEachEntryOfTheList) {
  EXPECT_EQ(by_name_.size(), robot::Sensors().size());
}

TEST_F(RobotSensorsTest, BaseIsThatOfOde) {
  EXPECT_EQ(*Reals("time"), 0.25);
  ExpectReals("base.position", dBodyGetPosition(base()), 3);
  ExpectReals("base.orientation", dBodyGetQuaternion(base()), 4);
  ExpectReals("base.velocity", dBodyGetLinearVel(base()), 3);
  ExpectReals("base.angular_velocity", dBodyGetAngularVel(base()), 3);
}

TEST_F(RobotSensorsTest, RotationOrientationAndAxesAreConsistent) {
  const double* q = Reals("base.orientation");
  const Eigen::Matrix3d expected = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> rotation(
      Reals("base.rotation"));
  EXPECT_NEAR((rotation - expected).norm(), 0, 1e-12);
  const char* axes[] = {"base.forward", "base.left", "base.up"};
  for (int column = 0; column < 3; ++column) {
    const Eigen::Map<const Eigen::Vector3d> axis(Reals(axes[column]));
    EXPECT_EQ(axis, rotation.col(column)) << axes[column];
    // What the base calls (1, 0, 0) points there in the world.
    dVector3 in_world;
    dBodyVectorToWorld(base(), column == 0, column == 1, column == 2, in_world);
    EXPECT_NEAR((axis - Eigen::Vector3d(in_world[0], in_world[1], in_world[2])).norm(), 0, 1e-12);
  }
}

TEST_F(RobotSensorsTest, JointsAreThoseOfOde) {
  for (int j = 0; j < 17; ++j) {
    EXPECT_EQ(Reals("joint.angle")[j], dJointGetHingeAngle(world_.body().joint(j).id())) << j;
    EXPECT_EQ(Reals("joint.velocity")[j], dJointGetHingeAngleRate(world_.body().joint(j).id()))
        << j;
    EXPECT_EQ(Reals("joint.torque")[j], world_.controller().torques()[j]) << j;
  }
}

TEST_F(RobotSensorsTest, LinksAreThoseOfOde) {
  for (int i = 0; i < 18; ++i) {
    const dBodyID body = world_.body().body(i);
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(Reals("link.position")[3 * i + k], dBodyGetPosition(body)[k]);
      EXPECT_EQ(Reals("link.velocity")[3 * i + k], dBodyGetLinearVel(body)[k]);
      EXPECT_EQ(Reals("link.angular_velocity")[3 * i + k], dBodyGetAngularVel(body)[k]);
    }
    for (int k = 0; k < 4; ++k) {
      EXPECT_EQ(Reals("link.orientation")[4 * i + k], dBodyGetQuaternion(body)[k]);
    }
  }
}

TEST_F(RobotSensorsTest, ContactIsThatOfTheFilter) {
  const bool* contact = by_name_.at("contact")->Read().flags();
  int touching = 0;
  for (int i = 0; i < 18; ++i) {
    EXPECT_EQ(contact[i], world_.contacts().flag(i)) << i;
    touching += contact[i];
  }
  EXPECT_GT(touching, 0);
}

TEST_F(RobotSensorsTest, MemoryStaysInPlace) {
  std::map<std::string_view, const void*> before;
  for (auto& [name, sensor] : by_name_) before[name] = sensor->Read().data;
  World other(Humanoid(), FindProfile("fast"), Humanoid().poses[0]);
  sensors_.Refresh(other, 0);
  for (auto& [name, sensor] : by_name_) EXPECT_EQ(sensor->Read().data, before[name]) << name;
  EXPECT_EQ(Reals("base.position")[2], Humanoid().poses[0].position[2]);
}

TEST_F(RobotSensorsTest, AreComputedOnceForEachRefresh) {
  const double first = Reals("base.position")[0];
  Move();
  EXPECT_EQ(Reals("base.position")[0], first);
  sensors_.Refresh(world_, 0.3);
  EXPECT_NE(Reals("base.position")[0], first);
}

TEST_F(RobotSensorsTest, FrozenSensorsKeepWhatWasReadLast) {
  const double position = Reals("base.position")[0];
  sensors_.Refresh(world_, 0.3);
  Move();
  sensors_.Freeze();
  EXPECT_EQ(Reals("base.position")[0], position);
  EXPECT_EQ(Reals("base.velocity")[0], 0);  // never read
  sensors_.Refresh(world_, 0.3);
  EXPECT_NE(Reals("base.position")[0], position);
}

}  // namespace
}  // namespace runtime
