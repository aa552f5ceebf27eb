// taskc completion bash|zsh|fish
#include "base/command_line/completion.h"
#include "compiler/driver/verb.h"
#include "compiler/source/diagnostic_table.h"
#include "plugins/robot/robot_description.h"
#include "plugins/robot/robot_names.h"

namespace compiler {
namespace {

command_line::ValueLists Lists() {
  std::vector<std::string> codes;
  for (const DiagnosticKind& kind : kDiagnosticTable) codes.emplace_back(kind.code);
  const auto robots = [](const auto&) { return robot::RobotNames(robot::RobotFolders({"."}, {})); };
  return {.words = {{"CODE", std::move(codes)}}, .names = {{"ROBOT", robots}}};
}

}  // namespace

Action DeclareCompletion(Command& command, Session&) {
  return [print = command_line::DeclareCompletion(command, Lists())](Session&) {
    print();
    return ExitStatus::kOk;
  };
}

}  // namespace compiler
