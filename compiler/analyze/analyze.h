// A file to a checked task, with all errors and warnings: what every tool begins with.
#pragma once

#include <filesystem>
#include <optional>

#include "compiler/check/checked_task.h"
#include "compiler/check/references.h"
#include "compiler/source/diagnostic.h"
#include "compiler/source/file_reader.h"
#include "compiler/source/sources.h"
#include "compiler/syntax/syntax_tree.h"
#include "plugins/robot/robot_description.h"
#include "plugins/world/world_description.h"

namespace compiler {

// As far as the compiler came: what is missing had errors.
struct Analysis {
  Sources sources;
  std::optional<SyntaxTree> tree;
  std::optional<robot::RobotDescription> robot;  // nothing also where the task names none
  std::optional<world::WorldDescription> world;  // likewise
  Diagnostics diagnostics;
  std::optional<CheckedTask> task;
};

// `robots`: where to look for robots first; may be empty. Throws CallError where `file` cannot be
// read, robot::DescriptionError where the robot is there but its file is wrong. What the names
// stand for goes to `references`, as far as it is known.
Analysis Analyze(const std::filesystem::path& file, const FileReader& read,
                 const std::filesystem::path& robots, References* references = nullptr);

}  // namespace compiler
