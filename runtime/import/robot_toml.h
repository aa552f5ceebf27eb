// A robot's description as its file.
#pragma once

#include <string>
#include <vector>

#include "plugins/robot/robot_description.h"

namespace runtime {

// A line of the list `links`.
std::string LinkText(const robot::Link& link);

// The text of a robot.toml. `comments`: lines at its beginning. Nets and ranges are left out.
std::string ToToml(const robot::RobotDescription& robot, const std::vector<std::string>& comments);

}  // namespace runtime
