// A robot and its motion in the messages of Foxglove (foxglove-sdk's schemas), as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/analysis/behavior/motion.h"

namespace runtime {

// JSON schemas of the fields that are written.
extern const char* const kSceneUpdateSchema;
extern const char* const kTransformsSchema;

// One entity for each link, which moves with the frame of the link's name. Its frame is at its
// center; boxes, capsules (two spheres and a cylinder) and spheres.
nlohmann::json SceneUpdate(const std::vector<robot::Link>& links);

// Each link's frame in `world`.
nlohmann::json FrameTransforms(const Motion& motion, int frame,
                               const std::vector<robot::Link>& links);

}  // namespace runtime
