// taskc spec --robot NAME
#include <memory>
#include <optional>
#include <sstream>

#include "base/text/print.h"
#include "compiler/driver/robot_option.h"
#include "compiler/driver/verb.h"
#include "compiler/spec/spec.h"
#include "compiler/toolchain/file_io.h"
#include "compiler/toolchain/share_folder.h"

namespace compiler {
namespace {

struct SpecOptions {
  std::string robot;             // empty: for tasks that declare their sensors
  std::filesystem::path output;  // empty: the standard output
  std::string format = "markdown";
};

SpecSources ReadSources() {
  SpecSources sources{ReadShareFile("spec/Task.g4"), ReadShareFile("spec/language.md"), {}};
  std::istringstream names(ReadShareFile("spec/examples.txt"));
  for (std::string name; std::getline(names, name);)
    sources.examples.push_back({name, ReadShareFile("spec/" + name)});
  return sources;
}

ExitStatus WriteSpec(const SpecOptions& options, Session& session) {
  std::optional<robot::RobotDescription> robot;
  if (!options.robot.empty()) robot = GetRobot(options.robot, "", session);
  const Spec spec = SpecOf(std::move(robot), ReadSources());
  const std::string text = options.format == "json" ? ToText(ToJson(spec)) : ToMarkdown(spec);
  if (options.output.empty()) {
    text::Print("{}", text);
  } else {
    ReplaceFile(options.output, text);
  }
  return ExitStatus::kOk;
}

}  // namespace

Action DeclareSpec(Command& command, Session& session) {
  auto options = std::make_shared<SpecOptions>();
  command
      .AddOption("--robot", options->robot,
                 "the robot; otherwise for tasks that declare their own sensors")
      .ValueName("ROBOT");
  AddOutput(command, options->output, "FILE.md|FILE.json",
            "where to write the page; otherwise it is printed");
  Option format = command.AddOption("--format", options->format, "a page, or data for programs")
                      .OneOf({"markdown", "json"})
                      .ShowDefault();
  command
      .OnFlag(
          "--json", [options] { options->format = "json"; }, "the same as --format json")
      .Excludes(format);
  AddRobots(command, session);
  return [options](Session& call) { return WriteSpec(*options, call); };
}

}  // namespace compiler
