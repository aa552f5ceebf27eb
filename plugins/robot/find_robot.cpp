#include <fmt/format.h>

#include <algorithm>

#include "base/file/search_path.h"
#include "plugins/robot/robot_description.h"
#include "plugins/robot/robot_names.h"
#include "plugins/robot/toml_value.h"

namespace robot {
namespace {

constexpr const char* kFileName = "robot.toml";

}  // namespace

std::vector<std::string> RobotNames(const std::vector<std::filesystem::path>& folders) {
  std::vector<std::string> names;
  for (const std::filesystem::path& folder : folders) {
    std::error_code ignored;  // a folder that cannot be read has no robots
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
      if (std::filesystem::exists(entry.path() / kFileName, ignored)) {
        names.push_back(entry.path().filename().string());
      }
    }
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

std::filesystem::path FindRobotFile(std::string_view name,
                                    const std::vector<std::filesystem::path>& folders) {
  for (const std::filesystem::path& folder : folders) {
    const std::filesystem::path file = folder / name / kFileName;
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored)) return file;
  }
  const std::vector<std::string> names = RobotNames(folders);
  std::string places;
  for (const std::filesystem::path& folder : folders) places += fmt::format(" {}", folder.string());
  throw DescriptionError(fmt::format(
      "there is no robot `{}`\n  help: {} (looked in{}; `--robots DIR` or TASKC_ROBOT_PATH look "
      "elsewhere)",
      name, SuggestName(name, names), places));
}

std::vector<std::filesystem::path> DefaultRobotFolders() {
  return file::SearchPath("TASKC_ROBOT_PATH", "robots");
}

std::vector<std::filesystem::path> RobotFolders(const std::vector<std::filesystem::path>& files,
                                                const std::filesystem::path& first) {
  std::vector<std::filesystem::path> folders;
  if (!first.empty()) folders.push_back(first);
  for (const std::filesystem::path& file : files) {
    std::filesystem::path beside = file.parent_path();
    if (beside.empty()) beside = ".";
    if (std::ranges::find(folders, beside) == folders.end()) folders.push_back(std::move(beside));
  }
  for (std::filesystem::path& folder : DefaultRobotFolders()) {
    folders.push_back(std::move(folder));
  }
  return folders;
}

}  // namespace robot
