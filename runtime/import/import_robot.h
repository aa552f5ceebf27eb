// Robots from the files of other programs: URDF, and MuJoCo's own format, MJCF.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace runtime {

struct ImportOptions {
  std::filesystem::path file{};                    // URDF or MJCF
  std::string name{};                              // of the robot; without one the file's
  std::filesystem::path folder{};                  // where the robot's own folder is made
  std::optional<bool> fixed_base{};                // without it as the file says
  std::function<void(const std::string&)> tell{};  // what takes some seconds, before it does
};

struct ImportedRobot {
  std::string name;
  std::filesystem::path file;         // its robot.toml
  std::vector<std::string> warnings;  // of what was left out or assumed
};

// Writes FOLDER/NAME/robot.toml and agent.toml. Throws UserError where the file is no model, where
// the robot is there already, or where this program was built without MuJoCo.
ImportedRobot ImportRobot(const ImportOptions& options);

}  // namespace runtime
