// Masses and inertias of a robot, and what they mean for its joints.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "plugins/robot/robot_description.h"

namespace runtime {

struct LinkProperties {
  double volume = 0;          // of its shape [m^3]
  Eigen::Vector3d principal;  // moments of inertia, ascending [kg m^2]
  double reach = 0;           // from its center of mass to the farthest point of its shape [m]
};

struct JointProperties {
  // What turns or shifts with the joint in the zero pose, where all other joints are locked and
  // nothing holds the robot but its base where that is fixed; with the armature [kg m^2, for each
  // rad].
  double inertia = 0;
  double reach = 0;          // to the center of the farthest link that it moves [m]
  double frequency = 0;      // at which it swings about its target; 0 without a motor [Hz]
  double damping_ratio = 0;  // 1 is critical; 0 without a motor
  // How many such robots its motor could hold up at the end of the longest limb, and how fast it
  // begins to turn what hangs on it [rad/s^2]; 0 without a motor that turns something.
  double strength = 0;
  double quickness = 0;

  // Many files say 1000 N m where nobody knew. With an armature such a motor may be meant.
  bool IsBeyondMotors() const { return strength > 5 && quickness > 5000; }
};

struct BodyProperties {
  double mass = 0;                      // [kg]
  std::vector<LinkProperties> links;    // of each
  std::vector<JointProperties> joints;  // of each
};

BodyProperties PropertiesOf(const robot::RobotDescription& robot);

}  // namespace runtime
