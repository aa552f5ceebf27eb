#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace robot {

// The robots in these folders, in alphabetical order.
std::vector<std::string> RobotNames(const std::vector<std::filesystem::path>& folders);

}  // namespace robot
