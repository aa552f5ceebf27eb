#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plugins/robot/robot_description.h"

namespace runtime {

// The shapes of the robot's links, for who draws the recordings: a JSON list with one object per
// link,
// {"name", "shape": "box"|"capsule"|"cylinder"|"sphere", "size": [x, y, z], "radius", "length",
// "axis": 0|1|2} and, where the shape is not around the link's center or turned, "position":
// [x, y, z], "orientation": [w, x, y, z].
std::string BodyJson(const robot::RobotDescription& robot);

// The links of BodyJson(), with their names and shapes and nothing else; nothing where the text is
// not such a list, or has a shape that no link can have.
std::optional<std::vector<robot::Link>> ParseBody(const std::string& json);

}  // namespace runtime
