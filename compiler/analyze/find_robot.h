// The robot that a task names.
#pragma once

#include <filesystem>
#include <optional>

#include "compiler/source/diagnostic.h"
#include "compiler/syntax/syntax_tree.h"
#include "plugins/robot/robot_description.h"

namespace compiler {

// Looks in robot::RobotFolders(task, first). A robot that is nowhere is a mistake in the task.
// Throws robot::DescriptionError where the robot is there but its file is wrong.
std::optional<robot::RobotDescription> FindRobot(const Identifier& name,
                                                 const std::filesystem::path& task,
                                                 const std::filesystem::path& first,
                                                 Diagnostics& diagnostics);

}  // namespace compiler
