#include <memory>
#include <optional>

#include "base/text/print.h"
#include "plugins/robot/robot_description.h"
#include "runtime/analysis/robot/pose_pictures.h"
#include "runtime/analysis/robot/robot_report.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/robot/hull_command.h"
#include "runtime/trainer/robot/import_command.h"
#include "runtime/trainer/setup/task_setup.h"
#include "runtime/training/run/run_files.h"
#include "runtime/training/simulation/profile.h"

namespace runtime {
namespace {

struct ShowRobotOptions {
  std::string robot;  // a name, or its robot.toml
  std::filesystem::path robots;
  std::string profile = "paper";
  std::filesystem::path picture;
  int height = 260;
  bool json = false;
};

robot::RobotDescription Read(const ShowRobotOptions& options) {
  const std::filesystem::path file = options.robot;
  if (file.extension() == ".toml") return robot::ReadRobot(file);
  const auto folders = robot::RobotFolders({"."}, options.robots);
  return robot::ReadRobotCalled(options.robot, robot::FindRobotFile(options.robot, folders));
}

int ShowRobot(const ShowRobotOptions& options) {
  const robot::RobotDescription robot = Read(options);
  const RobotReport report(robot, FindProfile(options.profile));
  if (!options.picture.empty()) {
    WriteOutput(options.picture, "the pictures", PosePictures(robot, report.poses, options.height));
  }
  if (options.json) {
    text::Print("{}\n",
                ToJson(report).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  } else {
    text::Print("{}", ToText(report));
  }
  return report.HasFailed() ? kFailed : kSuccess;
}

void AddShowRobotCommand(command_line::Command& robot) {
  const auto options = std::make_shared<ShowRobotOptions>();
  command_line::Command& show = robot.AddCommand(
      "show",
      "Checks a robot: its masses and inertias, and what becomes of each of its poses when the "
      "joints hold it for a second. Fails where the simulation diverges.");
  show.AddOption("ROBOT", options->robot, "the robot's name, or its robot.toml").Required();
  AddRobotsOption(show, options->robots);
  AddProfileOption(show, options->profile).ShowDefault();
  const command_line::Option picture =
      show.AddOption("-o,--output", options->picture,
                     "PNG file to write: each pose as it starts, with the axes and ranges of its "
                     "joints and the axes of its sites, and after the second")
          .ValueName("FILE");
  show.AddOption("--height", options->height, "height of the pictures, in pixels")
      .ShowDefault()
      .Range(16, 4096)
      .Needs(picture);
  show.AddFlag("--json", options->json, "print JSON");
  show.OnRun([options] { return ShowRobot(*options); });
}

}  // namespace

void AddRobotCommand(command_line::Command& program) {
  command_line::Command& robot =
      program.AddCommand("robot", "Checks robots, and makes them of other programs' files.");
  AddShowRobotCommand(robot);
  AddImportRobotCommand(robot);
  AddHullCommand(robot);
}

}  // namespace runtime
