// What the humanoid's sensors show at one moment, as plain numbers.
#pragma once

#include <Eigen/Dense>
#include <random>
#include <string>

#include "plugins/robot/robot_description.h"
#include "tests/compiler/emit/compiled_task.h"

namespace examples {

inline constexpr int kLinks = 18;
inline constexpr int kJoints = 17;

using OfLinks = Eigen::Matrix<double, 3, kLinks>;  // a column for each link
using OfJoints = Eigen::Array<double, kJoints, 1>;

// SI units; what is a vector is in the world frame.
struct RobotState {
  double time = 0;
  Eigen::Vector3d position;          // of the base
  Eigen::Quaterniond orientation;    // of the base, to the world
  Eigen::Vector3d velocity;          // of the base
  Eigen::Vector3d angular_velocity;  // of the base
  OfLinks link_positions;
  OfLinks link_velocities;
  OfLinks contact_forces;
  OfJoints angles;
  OfJoints joint_velocities;
  OfJoints joint_accelerations;
  OfJoints torques;
  OfJoints targets;
  // What comes from outside.
  double wish = 0;         // a speed
  Eigen::Vector2d leader;  // a place on the ground

  // Whether the link touches the ground: less than 1 N is no contact.
  bool Touches(int link) const { return contact_forces.col(link).norm() > 1; }
};

const robot::RobotDescription& Humanoid();
// Unknown names throw.
int LinkOf(const std::string& name);
int JointOf(const std::string& name);

// A state in which each condition of the tasks holds now and then: a third of the robots stand
// nearly upright at full height, with their links about in their places, and most have nothing but
// their feet on the ground.
RobotState RandomState(std::mt19937_64& random, double time);

// Sets all sensors that the task reads, but for those that only the learner sees.
void Sense(const RobotState& state, const taskc_plugin& plugin, compiler::Instance& instance);

}  // namespace examples
