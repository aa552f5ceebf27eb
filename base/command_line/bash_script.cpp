#include <fmt/format.h>

#include "base/command_line/shell_script.h"
#include "base/text/shell_word.h"

namespace command_line {
namespace {

using Commands = std::vector<CommandEntry>;

std::string BashWords(const std::vector<std::string>& words) {
  return fmt::format("compgen -W {} -- \"$current\"", text::ShellWord(Joined(words)));
}

// The commands that complete `$current`; "" for none.
std::string BashReply(const std::string& program, const CompletedValue& value) {
  std::vector<std::string> replies;
  if (!value.words.empty()) replies.push_back(BashWords(value.words));
  if (!value.names.empty()) {
    replies.push_back(fmt::format("compgen -W \"$({})\" -- \"$current\"",
                                  NamesCommand(program, value.names, "\"${COMP_WORDS[*]}\"")));
  }
  for (const std::string& suffix : value.suffixes) {
    replies.push_back(fmt::format("compgen -f -X '!*{}' -- \"$current\"", suffix));
  }
  const bool has_any_file = value.has_files && value.suffixes.empty();
  if (has_any_file) replies.emplace_back("compgen -f -- \"$current\"");
  if (value.has_folders && !has_any_file) replies.emplace_back("compgen -d -- \"$current\"");
  return Joined(replies, "; ");
}

// A case that completes `value`; "" where there is nothing to complete.
std::string BashCase(const std::string& program, const std::string& pattern,
                     const CompletedValue& value) {
  const std::string reply = BashReply(program, value);
  const char* files = value.has_files || value.has_folders ? "files=1; " : "";
  return fmt::format("    {}) {}{};;\n", pattern, files,
                     reply.empty() ? "" : "reply=$(" + reply + ") ");
}

std::string BashValues(const std::string& program, const Commands& commands) {
  std::string cases;
  for (const CommandEntry& command : commands) {
    for (const OptionEntry& option : command.options) {
      if (option.is_flag) continue;
      for (const std::string& name : option.names) {
        cases += BashCase(program, text::ShellWord(command.path + ":" + name), option.completed);
      }
    }
  }
  return cases;
}

std::string BashOptions(const Commands& commands) {
  std::string cases;
  for (const CommandEntry& command : commands) {
    cases += fmt::format("    {}) reply=$({}) ;;\n", text::ShellWord(command.path),
                         BashWords(OptionNames(command)));
  }
  return cases;
}

// What may stand where no option does: a command, or an argument in its place.
std::string BashArguments(const std::string& program, const Commands& commands) {
  std::string cases;
  for (const CommandEntry& command : commands) {
    if (!command.commands.empty()) {
      cases += fmt::format("    {}) reply=$({}; {}) ;;\n", text::ShellWord(command.path + ":1"),
                           BashWords(command.commands), BashWords(OptionNames(command)));
    }
    for (size_t i = 0; i < command.arguments.size(); ++i) {
      const OptionEntry& argument = command.arguments[i];
      const std::string place = argument.takes_many ? "" : std::to_string(i + 1);
      cases += BashCase(
          program, text::ShellWord(command.path + ":" + place) + (argument.takes_many ? "*" : ""),
          argument.completed);
    }
  }
  return cases;
}

}  // namespace

std::string BashScript(const std::string& program, const Commands& commands) {
  return fmt::format(
      "# Completion of {0} for bash.\n"
      "_{0}() {{\n"
      "  local current=${{COMP_WORDS[COMP_CWORD]}} command='' option='' place=1 word reply='' "
      "files='' joined=''\n"
      "  for word in \"${{COMP_WORDS[@]:1:COMP_CWORD - 1}}\"; do\n"
      "    if [[ $word == '=' ]]; then joined=1; continue; fi  # as bash takes apart a word with "
      "it\n"
      "    if [[ $option || $joined ]]; then option='' joined=''; continue; fi\n"
      "    case \"$command:$word\" in\n"
      "    {1}) command=${{command:+$command }}$word; place=1 ;;\n"
      "    {2}) option=$word ;;\n"
      "    *:-*) ;;\n"
      "    *) ((++place)) ;;\n"
      "    esac\n"
      "  done\n"
      "  if [[ $current == '=' ]]; then joined=1 current=''; fi\n"
      "  if [[ $option ]]; then\n"
      "    case \"$command:$option\" in\n"
      "{3}"
      "    esac\n"
      "  elif [[ $joined ]]; then\n"
      "    return\n"
      "  elif [[ $current == -* ]]; then\n"
      "    case $command in\n"
      "{4}"
      "    esac\n"
      "  else\n"
      "    case \"$command:$place\" in\n"
      "{5}"
      "    esac\n"
      "  fi\n"
      "  [[ $files ]] && compopt -o filenames 2>/dev/null\n"
      "  [[ $reply == *= ]] && compopt -o nospace 2>/dev/null\n"
      "  mapfile -t COMPREPLY < <(printf '%s' \"$reply\")\n"
      "}}\n"
      "complete -F _{0} {0}\n",
      program, Joined(Steps(commands), " | "), Joined(OptionsWithValue(commands), " | "),
      BashValues(program, commands), BashOptions(commands), BashArguments(program, commands));
}

}  // namespace command_line
