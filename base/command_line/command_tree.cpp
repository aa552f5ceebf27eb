#include "base/command_line/command_tree.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>

namespace command_line {
namespace {

// "INT in [1 - 100]" is in [1, 100], and "POSITIVE" is positive.
std::string Limits(std::string text) {
  if (const size_t in = text.find(" in ["); in != std::string::npos) {
    text = text.substr(in + 1);
    if (const size_t dash = text.find(" - "); dash != std::string::npos)
      text.replace(dash, 3, ", ");
    return text;
  }
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::vector<std::string> NamesOf(const std::set<CLI::Option*>& options) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options) {
    if (!option->get_group().empty()) names.push_back(option->get_name());
  }
  std::ranges::sort(names);
  return names;
}

// What the argument of one command is, or that of any command.
CompletedValue ArgumentCalled(const std::string& name, const std::string& path,
                              const ValueLists& lists) {
  const std::string full_name = path + " " + name;
  return lists.names.contains(full_name) ? CompletedValue{.names = full_name}
                                         : ValueCalled(name, lists);
}

OptionEntry EntryOf(const CLI::Option& option, const std::string& path, const ValueLists& lists) {
  OptionEntry entry;
  for (const std::string& name : option.get_snames()) entry.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) entry.names.push_back("--" + name);
  if (option.get_positional()) entry.names.push_back(option.get_name(true));
  entry.description = option.get_description();
  entry.is_required = option.get_required();
  entry.needs = NamesOf(option.get_needs());
  entry.excludes = NamesOf(option.get_excludes());
  entry.is_flag = option.get_items_expected_max() == 0;
  if (entry.is_flag) return entry;
  entry.takes_many = option.get_items_expected_max() > 1;
  entry.default_value = option.get_default_str();
  const std::string type = option.get_type_name();
  const size_t colon = type.find(':');
  const std::string value = type.substr(0, colon);
  if (colon != std::string::npos) entry.limits = Limits(type.substr(colon + 1));
  if (!option.get_positional()) entry.value = value;
  // An argument's own name, unless it has choices: "FILE.stl|FILE.obj".
  const bool by_name = option.get_positional() && value.find('|') == std::string::npos;
  entry.completed =
      by_name ? ArgumentCalled(entry.names.front(), path, lists) : ValueCalled(value, lists);
  return entry;
}

void AddEntries(const Command& command, const std::string& path, const ValueLists& lists,
                std::vector<CommandEntry>& entries) {
  const CLI::App& app = command.app();
  CommandEntry entry{path, command.name(), app.get_description(), app.get_group(), {}, {},
                     {},   command.notes()};
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;  // hidden
    auto& list = option->get_positional() ? entry.arguments : entry.options;
    list.push_back(EntryOf(*option, path, lists));
  }
  if (const auto& word = command.first_word()) {
    OptionEntry& first = entry.arguments.emplace_back();
    first.names = {word->first};
    first.description = word->second;
    first.is_required = true;
    first.completed = ArgumentCalled(word->first, path, lists);
  }
  std::vector<const Command*> below;
  for (const auto& each : command.commands()) {
    if (each->app().get_group().empty()) continue;
    below.push_back(each.get());
    entry.commands.push_back(each->name());
  }
  entries.push_back(std::move(entry));
  for (const Command* each : below) {
    AddEntries(*each, path + (path.empty() ? "" : " ") + each->name(), lists, entries);
  }
}

}  // namespace

std::vector<CommandEntry> CommandsOf(const Command& program, const ValueLists& lists) {
  std::vector<CommandEntry> entries;
  AddEntries(program, "", lists, entries);
  return entries;
}

const CommandEntry& Below(const CommandEntry& command, const std::string& name,
                          const std::vector<CommandEntry>& commands) {
  const std::string path = command.path + (command.path.empty() ? "" : " ") + name;
  return *std::ranges::find(commands, path, &CommandEntry::path);
}

}  // namespace command_line
