#include "base/command_line/completion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "base/text/shell_word.h"

namespace command_line {
namespace {

using Commands = std::vector<CompletedCommand>;

std::string Joined(const std::vector<std::string>& words, const char* separator = " ") {
  return fmt::format("{}", fmt::join(words, separator));
}

// All shells follow the words of the line from command to command in a variable, `command`, which
// is empty at first. These are the steps that there are: 'ctl module:add'.
std::vector<std::string> Steps(const Commands& commands) {
  std::vector<std::string> steps;
  for (const CompletedCommand& command : commands) {
    for (const std::string& name : command.commands) {
      steps.push_back(text::ShellWord(command.path + ":" + name));
    }
  }
  return steps;
}

std::vector<std::string> OptionNames(const CompletedCommand& command) {
  std::vector<std::string> names;
  for (const CompletedOption& option : command.options) {
    names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return names;
}

// ---- bash ---------------------------------------------------------------------------------------

std::string BashWords(const std::vector<std::string>& words) {
  return fmt::format("compgen -W {} -- \"$current\"", text::ShellWord(Joined(words)));
}

// The command that completes `$current`.
std::string BashReply(const CompletedValue& value) {
  switch (value.kind) {
    case CompletedValue::kNone:
    case CompletedValue::kText:
      return ":";
    case CompletedValue::kWords:
      return BashWords(value.words);
    case CompletedValue::kTask:
      return "compgen -f -X '!*.task' -- \"$current\"; compgen -d -- \"$current\"";
    case CompletedValue::kFile:
      return "compgen -f -- \"$current\"";
    case CompletedValue::kFolder:
      return "compgen -d -- \"$current\"";
  }
  return ":";
}

// What may stand next, where it is no option: a command, or else an argument.
std::string BashNext(const CompletedCommand& command) {
  if (command.commands.empty()) return BashReply(command.argument);
  return BashWords(command.commands) + "; " + BashWords(OptionNames(command));
}

std::string ToBash(const std::string& program, const Commands& commands) {
  std::string values, options, next;
  for (const CompletedCommand& command : commands) {
    for (const CompletedOption& option : command.options) {
      if (option.value.kind == CompletedValue::kNone) continue;
      for (const std::string& name : option.names) {
        values += fmt::format("    {}) reply=$({}) ;;\n",
                              text::ShellWord(command.path + ":" + name), BashReply(option.value));
      }
    }
    const std::string path = text::ShellWord(command.path);
    options += fmt::format("    {}) reply=$({}) ;;\n", path, BashWords(OptionNames(command)));
    next += fmt::format("    {}) reply=$({}) ;;\n", path, BashNext(command));
  }
  return fmt::format(
      "# Completion of {0} for bash.\n"
      "_{0}() {{\n"
      "  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}}\n"
      "  local command='' word reply=''\n"
      "  for word in \"${{COMP_WORDS[@]:1:COMP_CWORD - 1}}\"; do\n"
      "    case \"$command:$word\" in\n"
      "    {1}) command=${{command:+$command }}$word ;;\n"
      "    esac\n"
      "  done\n"
      "  case \"$command:$previous\" in\n"
      "{2}"
      "  *)\n"
      "    case $current in\n"
      "    -*) case $command in\n"
      "{3}"
      "    esac ;;\n"
      "    *) case $command in\n"
      "{4}"
      "    esac ;;\n"
      "    esac ;;\n"
      "  esac\n"
      "  mapfile -t COMPREPLY < <(printf '%s' \"$reply\")\n"
      "}}\n"
      "complete -o filenames -F _{0} {0}\n",
      program, Joined(Steps(commands), " | "), values, options, next);
}

// ---- zsh ----------------------------------------------------------------------------------------

std::string ZshAction(const CompletedValue& value) {
  switch (value.kind) {
    case CompletedValue::kNone:
    case CompletedValue::kText:
      return "";
    case CompletedValue::kWords:
      return fmt::format("({})", fmt::join(value.words, " "));
    case CompletedValue::kTask:
      return "_files -g \"*.task\"";
    case CompletedValue::kFile:
      return "_files";
    case CompletedValue::kFolder:
      return "_files -/";
  }
  return "";
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

std::string ZshArguments(const CompletedCommand& command) {
  std::string text = "_arguments";
  for (const CompletedOption& option : command.options) {
    for (const std::string& name : option.names) {
      std::string spec = fmt::format("{}[{}]", name, ZshText(option.description));
      if (option.value.kind != CompletedValue::kNone) spec += ": :" + ZshAction(option.value);
      text += " " + text::ShellWord(spec);
    }
  }
  if (!command.commands.empty()) return text + " '1: :->command'";
  if (command.argument.kind == CompletedValue::kNone) return text;
  return text + " " + text::ShellWord("*: :" + ZshAction(command.argument));
}

const CompletedCommand& Below(const CompletedCommand& command, const std::string& name,
                              const Commands& commands) {
  const std::string path = command.path + (command.path.empty() ? "" : " ") + name;
  return *std::ranges::find(commands, path, &CompletedCommand::path);
}

std::string ToZsh(const std::string& program, const Commands& commands) {
  std::string cases;
  for (const CompletedCommand& command : commands) {
    cases += fmt::format("  ({})\n", text::ShellWord(command.path));
    for (const std::string& name : command.commands) {
      const CompletedCommand& below = Below(command, name, commands);
      cases +=
          "    names+=" + fmt::format("({})\n", text::ShellWord(ZshText(name) + ":" + below.title));
    }
    cases += "    " + ZshArguments(command) + " ;;\n";
  }
  return fmt::format(
      "#compdef {0}\n"
      "# Completion of {0} for zsh.\n"
      "_{0}() {{\n"
      "  local command='' state='' at=1 i\n"
      "  local -a names\n"
      "  for ((i = 2; i < CURRENT; ++i)); do\n"
      "    case \"${{command}}:${{words[i]}}\" in\n"
      "    ({1}) command=\"${{command:+$command }}${{words[i]}}\"; at=$i ;;\n"
      "    esac\n"
      "  done\n"
      "  words=(\"${{(@)words[at,-1]}}\")\n"
      "  ((CURRENT -= at - 1))\n"
      "  case $command in\n"
      "{2}"
      "  esac\n"
      "  if [[ $state == command ]]; then _describe 'command' names; fi\n"
      "}}\n"
      "compdef _{0} {0}\n",
      program, Joined(Steps(commands), "|"), cases);
}

// ---- fish ---------------------------------------------------------------------------------------

std::string FishValue(const CompletedValue& value) {
  switch (value.kind) {
    case CompletedValue::kNone:
      return "";
    case CompletedValue::kText:
      return " -x";
    case CompletedValue::kWords:
      return " -x -a " + text::ShellWord(Joined(value.words));
    case CompletedValue::kTask:
      return " -x -a '(__fish_complete_suffix .task)'";
    case CompletedValue::kFile:
      return " -r -F";
    case CompletedValue::kFolder:
      return " -x -a '(__fish_complete_directories)'";
  }
  return "";
}

std::string FishCommand(const std::string& program, const CompletedCommand& command,
                        const Commands& commands) {
  const std::string begin =
      fmt::format("complete -c {0} -n \"__{0}_at '{1}'\"", program, command.path);
  std::string text;
  for (const std::string& name : command.commands) {
    text += fmt::format("{} -a {} -d {}\n", begin, name,
                        text::ShellWord(Below(command, name, commands).title));
  }
  for (const CompletedOption& option : command.options) {
    text += begin;
    for (const std::string& name : option.names) {
      const bool is_long = name.starts_with("--");
      text += (is_long ? " -l " : " -s ") + name.substr(is_long ? 2 : 1);
    }
    text += " -d " + text::ShellWord(option.description) + FishValue(option.value) + "\n";
  }
  const bool has_argument = command.argument.kind != CompletedValue::kNone &&
                            command.argument.kind != CompletedValue::kText;
  return has_argument ? text + begin + FishValue(command.argument) + "\n" : text;
}

std::string ToFish(const std::string& program, const Commands& commands) {
  std::string text = fmt::format(
      "# Completion of {0} for fish.\n"
      "function __{0}_at\n"
      "  set -l command ''\n"
      "  for word in (commandline -opc)[2..-1]\n"
      "    switch \"$command:$word\"\n"
      "      case {1}\n"
      "        set command (string trim \"$command $word\")\n"
      "    end\n"
      "  end\n"
      "  test \"$command\" = \"$argv[1]\"\n"
      "end\n"
      "complete -c {0} -f\n",
      program, Joined(Steps(commands)));
  for (const CompletedCommand& command : commands) text += FishCommand(program, command, commands);
  return text;
}

}  // namespace

void AddShell(Command& command, std::string& shell) {
  command.AddOption("SHELL", shell, "for which shell").OneOf({"bash", "zsh", "fish"}).Required();
}

std::string Completion(const std::string& shell, const Command& program,
                       const ArgumentWords& words) {
  const Commands commands = CommandsOf(program, words);
  const std::string& name = program.name();
  if (shell == "bash") return ToBash(name, commands);
  return shell == "zsh" ? ToZsh(name, commands) : ToFish(name, commands);
}

}  // namespace command_line
