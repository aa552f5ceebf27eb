// A file to a checked task, with all errors and warnings: what every tool begins with.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "compiler/check/checked_task.h"
#include "compiler/source/diagnostic.h"
#include "compiler/source/source_file.h"
#include "compiler/syntax/syntax_tree.h"
#include "plugins/robot/robot_description.h"

namespace compiler {

// Reads a file's text: nothing if there is none. The editor's server answers with what is being
// edited.
using FileReader = std::function<std::optional<std::string>(const std::filesystem::path&)>;

// What is on the disk.
std::optional<std::string> ReadFromDisk(const std::filesystem::path& file);

// As far as the compiler came: what is missing had errors.
struct Analysis {
  SourceFile source;
  std::optional<SyntaxTree> tree;
  std::optional<robot::RobotDescription> robot;  // nothing also where the task names none
  Diagnostics diagnostics;
  std::optional<CheckedTask> task;
};

// `robots`: where to look for robots first; may be empty. Throws CallError where `file` cannot be
// read, robot::DescriptionError where the robot is there but its file is wrong.
Analysis Analyze(const std::filesystem::path& file, const FileReader& read,
                 const std::filesystem::path& robots);

}  // namespace compiler
