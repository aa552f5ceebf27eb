#include "runtime/import/import_robot.h"

#include <fmt/format.h>

#include "plugins/robot/robot_description.h"
#include "runtime/base/user_error.h"
#include "runtime/import/complete_robot.h"
#include "runtime/import/describe_model.h"
#include "runtime/import/load_model.h"
#include "runtime/import/names.h"
#include "runtime/import/robot_toml.h"
#include "runtime/training/run/run_files.h"
#include "runtime/training/simulation/ode_library.h"

namespace runtime {
namespace {

std::vector<double> FirstKeyframe(const mjModel& model) {
  if (model.nkey == 0) return {};
  return {model.key_qpos, model.key_qpos + model.nq};
}

// A file may have numbers that no robot can have, as infinite ones.
void CheckWritten(const std::filesystem::path& robot, const std::filesystem::path& model) {
  try {
    robot::ReadRobot(robot);
  } catch (const robot::DescriptionError& error) {
    std::filesystem::remove(robot);
    std::error_code ignored;  // there may be other files
    std::filesystem::remove(robot.parent_path(), ignored);
    const std::string_view what = error.what();  // in the file that is gone
    constexpr std::string_view kBegin = "error: ";
    const size_t begin = what.find(kBegin);
    throw UserError(fmt::format("{}: what it describes is no robot: {}", model.string(),
                                begin == what.npos ? what : what.substr(begin + kBegin.size())));
  }
}

constexpr const char* kAgent =
    "# PPO that moves each joint around the start pose; docs/robots.md and `trainer agent show`\n"
    "# say what else there is.\n"
    "include = [\"ppo\"]\n\n"
    "[modules.action_space]\n"
    "hold = 4         # time steps of 5 ms\n"
    "scale = 1.0      # [rad]\n";

}  // namespace

ImportedRobot ImportRobot(const ImportOptions& options) {
  ImportedRobot imported;
  imported.name =
      Names().Take(options.name.empty() ? options.file.stem().string() : options.name, "robot");
  const std::filesystem::path folder = options.folder / imported.name;
  imported.file = folder / "robot.toml";
  if (std::filesystem::exists(imported.file)) {
    throw UserError(
        fmt::format("{} is there already: give the robot another name with `--name`, "
                    "or remove it",
                    imported.file.string()));
  }
  ModelFile file(options.file);
  const MujocoModel model = LoadModel(file);
  DescribedModel described = DescribeModel(file, *model, options.fixed_base);
  described.robot.name = imported.name;
  described.robot.doc = fmt::format("Imported from {}.", options.file.filename().string());
  try {
    CompleteRobot(described, FirstKeyframe(*model), options.tell);
  } catch (const OdeFailure& failure) {
    throw UserError(fmt::format("{}: what it describes cannot be simulated: {}",
                                options.file.string(), failure.what()));
  }
  imported.warnings = file.warnings();
  imported.warnings.insert(imported.warnings.end(), described.warnings.begin(),
                           described.warnings.end());
  std::filesystem::create_directories(folder);
  const std::vector<std::string> comments = {
      fmt::format("Imported from {} by `trainer robot import`.", options.file.filename().string())};
  WriteOutput(imported.file, "the robot", ToToml(described.robot, comments));
  CheckWritten(imported.file, options.file);
  WriteOutput(folder / "agent.toml", "its agent", kAgent);
  return imported;
}

}  // namespace runtime
