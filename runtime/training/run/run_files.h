// What a run's folder keeps beside its database, so that it goes on even if the sources have
// changed.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

#include "plugins/robot/robot_description.h"

namespace runtime {

// Makes the folder of a run, with those it lies in, where it is not there yet. Throws UserError.
void MakeRunFolder(const std::filesystem::path& folder);

// The run's database in its folder.
std::filesystem::path RunDatabaseFile(const std::filesystem::path& folder);

// Copies the shared object, a task's plugin or a library of modules, into `folder` (made if need
// be) under a name that holds its hash; returns this name when the disk has it. Throws UserError
// where it cannot be read or written.
std::string KeepPlugin(const std::filesystem::path& plugin, const std::filesystem::path& folder);

// How KeepPlugin() will call it. Throws UserError where it cannot be read.
std::string KeptPluginName(const std::filesystem::path& plugin);

// The plugin in the run's folder. Throws RecordError where it is gone or was changed.
std::filesystem::path FindKeptPlugin(const std::filesystem::path& folder, const std::string& name);

// The robot with this description, which is written to `folder`/robot.toml for that; an empty one
// for "", that of a run without a robot.
robot::RobotDescription ReadKeptRobot(const std::filesystem::path& folder,
                                      const std::string& description);

// Whether a file of this name in a run's folder is one that KeepPlugin() has made, or began to.
bool IsKeptPlugin(std::string_view name);

// Renames, also on the disk. Returns why it could not be done.
std::error_code MoveFile(const std::filesystem::path& from, const std::filesystem::path& to);

// Writes under a temporary name in the same folder, then renames: no one ever sees, or maps, half a
// file, even after a power cut. Returns why it could not be done; then the old file is as it was.
std::error_code ReplaceFile(const std::filesystem::path& file, const std::string& bytes);

// The same; throws UserError where it cannot be done.
void WriteFile(const std::filesystem::path& file, const std::string& bytes);

// Makes or replaces a file that the user asked for by --output, whole or not at all. Throws
// UserError, which calls it `what`: "the report".
void WriteOutput(const std::filesystem::path& file, std::string_view what,
                 const std::string& bytes);

// The whole of a regular file. Throws UserError.
std::string ReadText(const std::filesystem::path& file);

}  // namespace runtime
