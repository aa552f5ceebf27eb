// A robot that the command line names.
#pragma once

#include <filesystem>
#include <string>

#include "compiler/driver/session.h"
#include "plugins/robot/robot_description.h"

namespace compiler {

// The robot called `name`, as a task in `file` would find it. Throws CallError where there is none,
// robot::DescriptionError where its file is wrong.
robot::RobotDescription GetRobot(const std::string& name, const std::filesystem::path& file,
                                 const Session& session);

}  // namespace compiler
