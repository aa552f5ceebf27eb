#include <fmt/format.h>

#include "base/command_line/shell_script.h"
#include "base/text/shell_word.h"

namespace command_line {
namespace {

using Commands = std::vector<CommandEntry>;

// In zsh, parentheses without alternatives mean something else.
std::string ZshPattern(const std::vector<std::string>& suffixes) {
  return suffixes.size() == 1 ? "*" + suffixes.front() : "*(" + Joined(suffixes, "|") + ")";
}

// An action of _arguments, which evaluates what is in braces.
std::string ZshAction(const std::string& program, const CompletedValue& value) {
  std::vector<std::string> steps;
  if (!value.words.empty()) steps.push_back("compadd -- " + Joined(value.words));
  if (!value.names.empty()) {
    steps.push_back(fmt::format(
        "names=($({})); compadd -- ${{names##*=}}; compadd -S \"\" -- ${{(M)names##*=}}",
        NamesCommand(program, value.names, "\"$whole\"")));
  }
  if (!value.suffixes.empty()) {
    steps.push_back(fmt::format("_files -g \"{}\"", ZshPattern(value.suffixes)));
  } else if (value.has_files) {
    steps.emplace_back("_files");
  } else if (value.has_folders) {
    steps.emplace_back("_files -/");
  }
  return steps.empty() ? "" : "{" + Joined(steps, "; ") + "}";
}

// In the words of _arguments, where a few signs have a meaning.
std::string ZshText(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string ZshArguments(const std::string& program, const CommandEntry& command) {
  std::string text = "_arguments";
  for (const OptionEntry& option : command.options) {
    for (const std::string& name : option.names) {
      std::string spec = fmt::format("{}[{}]", name, ZshText(option.description));
      if (!option.is_flag) spec += ": :" + ZshAction(program, option.completed);
      text += " " + text::ShellWord((option.takes_many ? "*" : "") + spec);
    }
  }
  if (!command.commands.empty()) return text + " '1: :->command'";
  for (const OptionEntry& argument : command.arguments) {
    const std::string action = ZshAction(program, argument.completed);
    text += " " + text::ShellWord((argument.takes_many ? "*: :" : ": :") + action);
  }
  return text;
}

std::string ZshCases(const std::string& program, const Commands& commands) {
  std::string cases;
  for (const CommandEntry& command : commands) {
    cases += fmt::format("  ({})\n", text::ShellWord(command.path));
    for (const std::string& name : command.commands) {
      const CommandEntry& below = Below(command, name, commands);
      cases +=
          "    names+=" + fmt::format("({})\n", text::ShellWord(ZshText(name) + ":" + below.title));
    }
    cases += "    " + ZshArguments(program, command) + " ;;\n";
  }
  return cases;
}

}  // namespace

std::string ZshScript(const std::string& program, const Commands& commands) {
  return fmt::format(
      "#compdef {0}\n"
      "# Completion of {0} for zsh.\n"
      "_{0}() {{\n"
      "  local command='' option='' state='' whole=\"${{words[*]}}\" at=1 i\n"
      "  local -a names\n"
      "  for ((i = 2; i < CURRENT; ++i)); do\n"
      "    if [[ -n $option ]]; then option=''; continue; fi\n"
      "    case \"${{command}}:${{words[i]}}\" in\n"
      "    ({1}) command=\"${{command:+$command }}${{words[i]}}\"; at=$i ;;\n"
      "    ({2}) option=${{words[i]}} ;;\n"
      "    esac\n"
      "  done\n"
      "  words=(\"${{(@)words[at,-1]}}\")\n"
      "  ((CURRENT -= at - 1))\n"
      "  case $command in\n"
      "{3}"
      "  esac\n"
      "  if [[ $state == command ]]; then _describe 'command' names; fi\n"
      "}}\n"
      "# As a file of fpath, it is the function itself that this defines.\n"
      "if [[ $funcstack[1] == _{0} ]]; then _{0} \"$@\"; else compdef _{0} {0}; fi\n",
      program, Joined(Steps(commands), "|"), Joined(OptionsWithValue(commands), "|"),
      ZshCases(program, commands));
}

}  // namespace command_line
