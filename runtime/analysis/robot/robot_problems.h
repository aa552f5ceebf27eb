// What is likely to be wrong with a robot's description.
#pragma once

#include <string>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/analysis/robot/body_properties.h"
#include "runtime/analysis/robot/held_pose.h"

namespace runtime {

struct RobotProblem {
  std::string text;  // "`trunk` is 0.2 m in the ground in pose `standing`"
  std::string help;  // what to do
};

// Of masses and inertias.
std::vector<RobotProblem> ProblemsOf(const robot::RobotDescription& robot,
                                     const BodyProperties& body);
// Of a pose and the way in which it is simulated. That a robot falls is not one: many have to learn
// to stand.
std::vector<RobotProblem> ProblemsOf(const robot::RobotDescription& robot, const HeldPose& held);

}  // namespace runtime
