// What a joint of a model is by itself. Its angles here are those there less the one in the model's
// first pose (`qpos0`), which is the zero pose here.
#pragma once

#include <mujoco/mujoco.h>

#include <string>

#include "plugins/robot/robot_description.h"
#include "runtime/import/model_file.h"

namespace runtime {

// Kind and stops of a hinge or a slide. False where the stops leave it nothing to move by.
bool ReadStops(const mjModel& model, int index, robot::Joint& joint);

robot::PassiveForces PassiveForcesOf(const mjModel& model, int index);

// What drives the joint, which the file calls `name`; gains that it does not say are proposed
// later.
robot::OwnGains MotorOf(const ModelFile& file, const mjModel& model, int index,
                        const std::string& name);

}  // namespace runtime
