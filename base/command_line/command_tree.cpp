#include "base/command_line/command_tree.h"

#include <CLI/CLI.hpp>
#include <sstream>

namespace command_line {
namespace {

std::vector<std::string> SplitAt(const std::string& text, char separator) {
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, separator);) words.push_back(word);
  return words;
}

// "text|json|sarif" and "TEXT:{paper,fast}" say their words; FILE.md|FILE.html does not.
std::vector<std::string> WordsIn(const std::string& type) {
  const size_t brace = type.find('{');
  if (brace != std::string::npos) {
    return SplitAt(type.substr(brace + 1, type.find('}') - brace - 1), ',');
  }
  const bool is_choice = type.find('|') != std::string::npos;
  return is_choice && type.find("FILE") == std::string::npos ? SplitAt(type, '|')
                                                             : std::vector<std::string>();
}

CompletedValue ValueOf(const CLI::Option& option, const ArgumentWords& words) {
  const std::string type = option.get_type_name();
  const std::string name = option.get_name();
  if (const auto known = words.find(name); known != words.end()) {
    return {CompletedValue::kWords, known->second};
  }
  if (std::vector<std::string> choices = WordsIn(type); !choices.empty()) {
    return {CompletedValue::kWords, std::move(choices)};
  }
  if (type == "DIR" || name == "DIR") return {CompletedValue::kFolder};
  if (name == "FILE.task" || name == "TASK") return {CompletedValue::kTask};
  const bool is_file = type.find("FILE") != std::string::npos || name.starts_with("FILE");
  return {is_file ? CompletedValue::kFile : CompletedValue::kText};
}

CompletedOption Completed(const CLI::Option& option, const ArgumentWords& words) {
  CompletedOption completed{{}, option.get_description(), {}};
  for (const std::string& name : option.get_snames()) completed.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) completed.names.push_back("--" + name);
  if (option.get_items_expected_max() > 0) completed.value = ValueOf(option, words);
  return completed;
}

void AddCommand(const CLI::App& app, const std::string& path, const ArgumentWords& words,
                std::vector<CompletedCommand>& commands) {
  CompletedCommand command{path, app.get_name(), app.get_description(), {}, {}, {}};
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;  // hidden
    if (!option->get_positional()) {
      command.options.push_back(Completed(*option, words));
    } else if (command.argument.kind <= CompletedValue::kText) {
      command.argument = ValueOf(*option, words);
    }
  }
  const auto below = app.get_subcommands([](const CLI::App*) { return true; });
  for (const CLI::App* each : below) command.commands.push_back(each->get_name());
  commands.push_back(std::move(command));
  for (const CLI::App* each : below) {
    AddCommand(*each, path + (path.empty() ? "" : " ") + each->get_name(), words, commands);
  }
}

}  // namespace

std::vector<CompletedCommand> CommandsOf(const Command& program, const ArgumentWords& words) {
  std::vector<CompletedCommand> commands;
  AddCommand(program.app(), "", words, commands);
  return commands;
}

}  // namespace command_line
