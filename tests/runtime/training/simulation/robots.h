// The robots of these tests.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/training/simulation/world.h"

namespace runtime {

inline const robot::RobotDescription& Humanoid() {
  static const robot::RobotDescription robot = robot::ReadRobot(HUMANOID);
  return robot;
}

inline const robot::RobotDescription& Hopper() {
  static const robot::RobotDescription robot = robot::ReadRobot(HOPPER);
  return robot;
}

inline const robot::RobotDescription& Tinker() {
  static const robot::RobotDescription robot = robot::ReadRobot(TINKER);
  return robot;
}

inline const robot::RobotDescription& Blocks() {
  static const robot::RobotDescription robot = robot::ReadRobot(BLOCKS);
  return robot;
}

// Two balls on one axis through both centers, far above the ground: the joint's angle is a damped
// oscillator with the reduced inertia, which has a known solution.
inline robot::RobotDescription Rotor() {
  robot::RobotDescription robot;
  robot.name = "rotor";
  robot.links = {{"hub", 1.0, {0, 0, 0}, {robot::ShapeKind::kSphere, {}, 0.1}},
                 {"wheel", 0.5, {0, 0, 0}, {robot::ShapeKind::kSphere, {}, 0.08}}};
  robot.joints = {{"axle", 0, 1, {0, 0, 1}, {0, 0, 0}, -3.14, 3.14}};
  robot.controller = {.stiffness = 0.02, .damping = 0.001, .max_torque = 10, .time_step = 0.005};
  robot.poses = {{"turned", {0, 0, 100}, {1, 0, 0, 0}, {0.5}}};
  return robot;
}

// The names of all profiles that there are in this build.
inline std::vector<const char*> BuiltProfiles() {
  std::vector<const char*> names;
  for (const Profile& profile : kProfiles) {
    if (profile.IsBuilt()) names.push_back(profile.name.data());
  }
  return names;
}

inline bool IsMujoco(const char* profile) {
  return FindProfile(profile).solver == SolverKind::kMujoco;
}

// Names a test after its profile.
inline std::string ProfileInName(const testing::TestParamInfo<const char*>& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

inline dBodyID Link(const World& world, const robot::RobotDescription& robot, const char* name) {
  return world.body().body(robot.FindLink(name).value());
}
inline dJointID Hinge(const World& world, const robot::RobotDescription& robot, const char* name) {
  return world.body().joint(robot.FindJoint(name).value()).id();
}

inline Eigen::Vector3d CenterOfMass(const World& world, const robot::RobotDescription& robot) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double mass = 0;
  for (size_t i = 0; i < robot.links.size(); ++i) {
    const double part = robot.links[i].mass;
    sum += part * ToEigen(dBodyGetPosition(world.body().body(static_cast<int>(i))));
    mass += part;
  }
  return sum / mass;
}

inline std::vector<double> Zeros(const robot::RobotDescription& robot) {
  return std::vector<double>(robot.joints.size(), 0.0);
}

inline void StepFor(World& world, double seconds, const std::vector<double>& targets) {
  const int steps = static_cast<int>(seconds / world.physics_time_step() + 0.5);
  for (int i = 0; i < steps; ++i) world.Step(targets);
}

inline std::vector<std::string> GroundLinks(const World& world,
                                            const robot::RobotDescription& robot) {
  std::vector<std::string> names;
  for (size_t i = 0; i < robot.links.size(); ++i) {
    if (world.collision().ground()[i]) names.push_back(robot.links[i].name);
  }
  return names;
}

}  // namespace runtime
