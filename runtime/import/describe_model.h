// A MuJoCo model as a robot of this project.
#pragma once

#include <mujoco/mujoco.h>

#include <optional>
#include <string>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/import/model_file.h"

namespace runtime {

struct DescribedModel {
  // Without controller and poses; the zero pose is that of the model's joints at their references.
  robot::RobotDescription robot;
  robot::Vector3 base{};  // where the base link's center is then, in the model's world
  // For each joint: where its number is in a `qpos` of the model, and what it is at angle 0.
  std::vector<int> qpos;
  std::vector<double> references;
  std::vector<std::string> warnings;
};

// `fixed_base`: what the user says of it; without that what the file says, and a URDF file, which
// does not, has a free one unless its first link is called `world`. Throws UserError for a model
// without a body.
DescribedModel DescribeModel(const ModelFile& file, const mjModel& model,
                             std::optional<bool> fixed_base);

}  // namespace runtime
