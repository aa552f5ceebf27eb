#include "compiler/analyze/find_robot.h"

#include <fmt/format.h>

#include <string_view>

namespace compiler {
namespace {

// A message and, behind `help:`, what to do.
Diagnostic UnknownRobot(const Identifier& name, std::string_view what) {
  constexpr std::string_view kHelp = "\n  help: ";
  size_t help = what.find(kHelp);
  Diagnostic diagnostic =
      MakeDiagnostic(code::kUnknownRobot, name.span, std::string(what.substr(0, help)));
  if (help != std::string_view::npos)
    diagnostic.help = std::string(what.substr(help + kHelp.size()));
  return diagnostic;
}

}  // namespace

std::optional<robot::RobotDescription> FindRobot(const Identifier& name,
                                                 const std::filesystem::path& task,
                                                 const std::filesystem::path& first,
                                                 Diagnostics& diagnostics) {
  std::filesystem::path file;
  try {
    file = robot::FindRobotFile(name.text, robot::RobotFolders({task}, first));
  } catch (const robot::DescriptionError& error) {
    diagnostics.Add(UnknownRobot(name, error.what()));
    return std::nullopt;
  }
  return robot::ReadRobotCalled(name.text, file);
}

}  // namespace compiler
