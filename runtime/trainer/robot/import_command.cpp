#include "runtime/trainer/robot/import_command.h"

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/text/print.h"
#include "runtime/import/import_robot.h"
#include "runtime/trainer/commands.h"

namespace runtime {
namespace {

struct ImportRobotOptions {
  ImportOptions import;
  std::string base;
  bool json = false;
};

int Import(ImportRobotOptions options) {
  if (!options.base.empty()) options.import.fixed_base = options.base == "fixed";
  options.import.tell = [](const std::string& what) { text::Print(stderr, "{}\n", what); };
  const ImportedRobot imported = ImportRobot(options.import);
  if (options.json) {
    const nlohmann::ordered_json json = {
        {"name", imported.name}, {"file", imported.file.string()}, {"warnings", imported.warnings}};
    text::Print("{}\n", json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
    return kSuccess;
  }
  for (const std::string& warning : imported.warnings)
    text::Print(stderr, "warning: {}\n", warning);
  text::Print("{}: the robot `{}`; `trainer robot show {}` checks it\n", imported.file.string(),
              imported.name, imported.file.string());
  return kSuccess;
}

}  // namespace

void AddImportRobotCommand(command_line::Command& robot) {
  const auto options = std::make_shared<ImportRobotOptions>();
  options->import.folder = "robots";
  command_line::Command& command = robot.AddCommand(
      "import",
      "Makes a robot of a URDF or MJCF file, and says what it could not take over. What the file "
      "leaves open is proposed: gains, a pose to start from, an agent.");
  command.AddOption("FILE", options->import.file, "the URDF or MJCF file")
      .Required()
      .ValueName("FILE.urdf|FILE.xml");
  command.AddOption("--name", options->import.name, "the robot's name, by default the file's");
  command.AddOption("--robots", options->import.folder, "folder in which the robot's own is made")
      .ShowDefault()
      .ValueName("DIR");
  command
      .AddOption("--base", options->base,
                 "whether something holds the first link; by default as the file says")
      .OneOf({"free", "fixed"});
  command.AddFlag("--json", options->json, "print JSON");
  command.OnRun([options] { return Import(*options); });
}

}  // namespace runtime
