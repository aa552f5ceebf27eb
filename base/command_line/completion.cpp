#include "base/command_line/completion.h"

#include <fmt/format.h>

#include <iterator>
#include <memory>
#include <sstream>
#include <vector>

#include "base/command_line/shell_script.h"
#include "base/text/print.h"

namespace command_line {
namespace {

struct CompletionOptions {
  std::string shell;
  std::string names;
  std::string line;
};

std::vector<std::string> WordsOf(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

void PrintNames(const std::string& list, const std::string& line, const ValueLists& lists) {
  const auto known = lists.names.find(list);
  if (known == lists.names.end()) throw CallError(fmt::format("there are no names `{}`", list));
  for (const std::string& name : known->second(WordsOf(line))) text::Print("{}\n", name);
}

std::string Examples(const std::string& program) {
  return fmt::format(
      "{0} completion bash >>~/.bashrc\n"
      "{0} completion zsh >>~/.zshrc       # after the line with compinit\n"
      "{0} completion fish >~/.config/fish/completions/{0}.fish",
      program);
}

}  // namespace

std::string Completion(const std::string& shell, const Command& program, const ValueLists& lists) {
  const std::vector<CommandEntry> commands = CommandsOf(program, lists);
  if (shell == "bash") return BashScript(program.name(), commands);
  if (shell == "zsh") return ZshScript(program.name(), commands);
  return FishScript(program.name(), commands);
}

std::function<void()> DeclareCompletion(Command& command, ValueLists lists) {
  const auto options = std::make_shared<CompletionOptions>();
  command.AddOption("SHELL", options->shell, "for which shell").OneOf({"bash", "zsh", "fish"});
  // What the scripts ask.
  command.AddOption("--names", options->names, "").Hidden();
  command.AddOption("--line", options->line, "").Hidden();
  command.Examples(Examples(command.program().name()));
  command.Notes("Where the program was installed for all users, the shells have it already.");
  return [options, &program = command.program(), lists = std::move(lists)] {
    if (!options->names.empty()) return PrintNames(options->names, options->line, lists);
    if (options->shell.empty()) throw CallError("for which shell: bash, zsh or fish?");
    text::Print("{}", Completion(options->shell, program, lists));
  };
}

}  // namespace command_line
