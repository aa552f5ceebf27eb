#include "base/command_line/shell_script.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text/shell_word.h"

namespace command_line {

std::string Joined(const std::vector<std::string>& words, const char* separator) {
  return fmt::format("{}", fmt::join(words, separator));
}

std::vector<std::string> Steps(const std::vector<CommandEntry>& commands) {
  std::vector<std::string> steps;
  for (const CommandEntry& command : commands) {
    for (const std::string& name : command.commands) {
      steps.push_back(text::ShellWord(command.path + ":" + name));
    }
  }
  return steps;
}

std::vector<std::string> OptionsWithValue(const std::vector<CommandEntry>& commands) {
  std::vector<std::string> options;
  for (const CommandEntry& command : commands) {
    for (const OptionEntry& option : command.options) {
      if (option.is_flag) continue;
      for (const std::string& name : option.names) {
        options.push_back(text::ShellWord(command.path + ":" + name));
      }
    }
  }
  return options;
}

std::vector<std::string> OptionNames(const CommandEntry& command) {
  std::vector<std::string> names;
  for (const OptionEntry& option : command.options) {
    names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return names;
}

std::string NamesCommand(const std::string& program, const std::string& list, const char* line) {
  return fmt::format("{} completion --names {} --line {} 2>/dev/null", program,
                     text::ShellWord(list), line);
}

}  // namespace command_line
