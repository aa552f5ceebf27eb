// The robot that a task names.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "compiler/source/diagnostic.h"
#include "compiler/syntax/syntax_tree.h"
#include "plugins/robot/robot_description.h"

namespace compiler {

// Where robots are searched for: the folder `first` (where it is not empty), that of the task, then
// where robots usually are.
std::vector<std::filesystem::path> RobotFolders(const std::filesystem::path& task,
                                                const std::filesystem::path& first);

// Looks in the folder `first` (where it is not empty), in that of the task, then where robots
// usually are. A robot that is nowhere is a mistake in the task. Throws robot::DescriptionError
// where the robot is there but its file is wrong.
std::optional<robot::RobotDescription> FindRobot(const Identifier& name,
                                                 const std::filesystem::path& task,
                                                 const std::filesystem::path& first,
                                                 Diagnostics& diagnostics);

}  // namespace compiler
