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
  double frequency = 0;      // at which it swings about its target; 0 without a motor [Hz]
  double damping_ratio = 0;  // 1 is critical; 0 without a motor
};

struct BodyProperties {
  double mass = 0;                      // [kg]
  std::vector<LinkProperties> links;    // of each
  std::vector<JointProperties> joints;  // of each
};

BodyProperties PropertiesOf(const robot::RobotDescription& robot);

}  // namespace runtime
