// trainer completion bash|zsh|fish
#include <fmt/format.h>

#include <memory>

#include "base/command_line/completion.h"
#include "base/text/print.h"
#include "runtime/trainer/commands.h"

namespace runtime {

void AddCompletionCommand(CLI::App& app, int& status) {
  const auto shell = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand(
      "completion", "Prints what a shell needs to complete trainer's command line.");
  command_line::AddShell(*command, *shell);
  command->footer(
      "Examples:\n"
      "  trainer completion bash >>~/.bashrc\n"
      "  trainer completion zsh >>~/.zshrc       # behind the line with compinit\n"
      "  trainer completion fish >~/.config/fish/completions/trainer.fish");
  command->callback([shell, &app, &status] {
    text::Print("{}", command_line::Completion(*shell, app));
    status = kSuccess;
  });
}

}  // namespace runtime
