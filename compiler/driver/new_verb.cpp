// taskc new NAME
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "base/text/print.h"
#include "compiler/driver/robot_option.h"
#include "compiler/driver/task_skeleton.h"
#include "compiler/driver/verb.h"
#include "compiler/syntax/parse.h"
#include "compiler/toolchain/file_io.h"

namespace compiler {
namespace {

struct NewOptions {
  std::string name;
  std::string robot;  // empty: none
};

// Throws CallError where a task cannot be called that.
void CheckName(const std::string& name) {
  const SourceFile header(name, "task " + name + "\n");
  Diagnostics diagnostics;
  const auto tree = Parse(header, diagnostics);
  const bool is_parsed = tree && tree->task && !diagnostics.has_errors();
  if (is_parsed && tree->task->text == name && !tree->robot && !tree->base) return;
  throw CallError(
      fmt::format("a task cannot be called `{}`: a name consists of letters, digits and `_`, does "
                  "not begin with a digit, and is not a keyword",
                  name));
}

ExitStatus New(const NewOptions& options, Session& session) {
  std::filesystem::path file = options.name;
  if (file.extension() != ".task") file += ".task";
  const std::string name = file.stem();
  CheckName(name);
  std::optional<robot::RobotDescription> robot;
  if (!options.robot.empty()) robot = GetRobot(options.robot, file, session);
  if (std::filesystem::exists(std::filesystem::symlink_status(file))) {
    throw CallError(fmt::format("`{}` already exists", file.string()));
  }
  ReplaceFile(file, TaskSkeleton(name, robot ? &*robot : nullptr));
  text::Print("{}\n", file.string());
  return ExitStatus::kOk;
}

}  // namespace

Action DeclareNew(Command& command, Session& session) {
  auto options = std::make_shared<NewOptions>();
  command.AddOption("NAME", options->name, "name of the task; the file is NAME.task")
      .Required()
      .ValueName("");
  command
      .AddOption("--for", options->robot, "the robot; otherwise the task declares its own sensors")
      .ValueName("ROBOT");
  AddRobots(command, session);
  return [options](Session& call) { return New(*options, call); };
}

}  // namespace compiler
