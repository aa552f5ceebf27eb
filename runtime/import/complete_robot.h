// What a model leaves open and a robot needs: gains, a pose to start from, names for what belongs
// together.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/import/describe_model.h"

namespace runtime {

// Completes the robot. `keyframe`: the angles of the model's first keyframe, or empty. Adds to the
// warnings what it had to assume.
//
// A motor without a largest torque gets what holds half of the robot's weight at the end of the
// limb. Stiffness: the whole torque at 0.4 rad; damping: half of the critical one, of the joint's
// own inertia with all others locked.
//
// Where the robot does not stand in the file's pose, another one is looked for (standing_pose.h).
// `tell`: hears of that before; may be empty.
void CompleteRobot(DescribedModel& model, const std::vector<double>& keyframe,
                   const std::function<void(const std::string&)>& tell);

}  // namespace runtime
