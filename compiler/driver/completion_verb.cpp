// taskc completion bash|zsh|fish
#include <fmt/format.h>

#include <memory>

#include "base/command_line/completion.h"
#include "base/text/print.h"
#include "compiler/driver/verb.h"
#include "compiler/source/diagnostic_table.h"

namespace compiler {
namespace {

command_line::ArgumentWords Codes() {
  std::vector<std::string> codes;
  for (const DiagnosticKind& kind : kDiagnosticTable) codes.emplace_back(kind.code);
  return {{"CODE", std::move(codes)}};
}

}  // namespace

Action DeclareCompletion(Command& command, Session&) {
  auto shell = std::make_shared<std::string>();
  command_line::AddShell(command, *shell);
  return [shell, &program = command.program()](Session&) {
    text::Print("{}", command_line::Completion(*shell, program, Codes()));
    return ExitStatus::kOk;
  };
}

}  // namespace compiler
