// trainer completion bash|zsh|fish
#include <memory>

#include "base/command_line/completion.h"
#include "base/text/print.h"
#include "runtime/trainer/commands.h"

namespace runtime {

void AddCompletionCommand(command_line::Command& program) {
  const auto shell = std::make_shared<std::string>();
  command_line::Command& command = program.AddCommand(
      "completion", "Prints a script that completes trainer's command line in a shell.");
  command_line::AddShell(command, *shell);
  command.Footer(
      "Examples:\n"
      "  trainer completion bash >>~/.bashrc\n"
      "  trainer completion zsh >>~/.zshrc       # behind the line with compinit\n"
      "  trainer completion fish >~/.config/fish/completions/trainer.fish");
  command.OnRun([shell, &program] {
    text::Print("{}", command_line::Completion(*shell, program));
    return kSuccess;
  });
}

}  // namespace runtime
