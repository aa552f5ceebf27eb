#include <fmt/format.h>

#include "base/command_line/shell_script.h"
#include "base/text/shell_word.h"

namespace command_line {
namespace {

using Commands = std::vector<CommandEntry>;

// Options of `complete` that say what to offer; "" for nothing.
std::string FishValue(const std::string& program, const CompletedValue& value) {
  std::vector<std::string> sources;
  if (!value.words.empty()) sources.push_back(Joined(value.words));
  if (!value.names.empty()) {
    sources.push_back(
        "(" + NamesCommand(program, value.names, "(commandline -cp | string collect)") + ")");
  }
  for (const std::string& suffix : value.suffixes) {
    sources.push_back(fmt::format("(__fish_complete_suffix {})", suffix));
  }
  if (value.has_folders && !value.has_files) sources.emplace_back("(__fish_complete_directories)");
  const bool has_any_file = value.has_files && value.suffixes.empty();
  std::string text = has_any_file ? " -F" : "";
  if (!sources.empty()) text += " -a " + text::ShellWord(Joined(sources));
  return text;
}

std::string FishOption(const std::string& program, const OptionEntry& option) {
  std::string text;
  for (const std::string& name : option.names) {
    const bool is_long = name.starts_with("--");
    text += (is_long ? " -l " : " -s ") + name.substr(is_long ? 2 : 1);
  }
  text += " -d " + text::ShellWord(option.description);
  if (option.is_flag) return text;
  const std::string value = FishValue(program, option.completed);
  return text + (value.starts_with(" -F") ? " -r" : " -x") + value;
}

std::string FishCommand(const std::string& program, const CommandEntry& command,
                        const Commands& commands) {
  const auto begin = [&](const std::string& place) {
    return fmt::format("complete -c {0} -n \"__{0}_at '{1}'{2}\"", program, command.path, place);
  };
  std::string text;
  for (const std::string& name : command.commands) {
    text += fmt::format("{} -a {} -d {}\n", begin(" 1"), name,
                        text::ShellWord(Below(command, name, commands).title));
  }
  for (const OptionEntry& option : command.options) {
    text += begin("") + FishOption(program, option) + "\n";
  }
  for (size_t i = 0; i < command.arguments.size(); ++i) {
    const OptionEntry& argument = command.arguments[i];
    const std::string value = FishValue(program, argument.completed);
    if (value.empty()) continue;
    text += begin(argument.takes_many ? "" : fmt::format(" {}", i + 1)) + value + "\n";
  }
  return text;
}

}  // namespace

std::string FishScript(const std::string& program, const Commands& commands) {
  std::string text = fmt::format(
      "# Completion of {0} for fish.\n"
      "# Whether the line is in a command and, where that is given, at which of its arguments.\n"
      "function __{0}_at\n"
      "  set -l command ''\n"
      "  set -l option ''\n"
      "  set -l place 1\n"
      "  for word in (commandline -opc)[2..-1]\n"
      "    if test -n \"$option\"\n"
      "      set option ''\n"
      "      continue\n"
      "    end\n"
      "    switch \"$command:$word\"\n"
      "      case {1}\n"
      "        set command (string trim \"$command $word\")\n"
      "        set place 1\n"
      "      case {2}\n"
      "        set option $word\n"
      "      case '*:-*'\n"
      "      case '*'\n"
      "        set place (math $place + 1)\n"
      "    end\n"
      "  end\n"
      "  test \"$command\" = \"$argv[1]\"; and contains -- \"$argv[2]\" '' $place\n"
      "end\n"
      "complete -c {0} -f\n",
      program, Joined(Steps(commands)), Joined(OptionsWithValue(commands)));
  for (const CommandEntry& command : commands) text += FishCommand(program, command, commands);
  return text;
}

}  // namespace command_line
