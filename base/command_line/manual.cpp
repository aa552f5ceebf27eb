#include "base/command_line/manual.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>

#include "base/command_line/command_tree.h"
#include "base/command_line/roff.h"

namespace command_line {
namespace {

constexpr const char* kDefaultGroup = "Subcommands";  // CLI11's

// "trainer-ctl-swap"
std::string PageName(const std::string& program, const std::string& path) {
  std::string name = program + (path.empty() ? "" : " ") + path;
  std::ranges::replace(name, ' ', '-');
  return name;
}

std::string Reference(const std::string& page) { return RoffBold(page) + "(1)"; }

std::string Section(const std::string& heading, const std::string& text) {
  return text.empty() ? "" : fmt::format(".SH \"{}\"\n{}", heading, text);
}

std::string Paragraph(const std::string& text) { return text.empty() ? "" : RoffText(text) + "\n"; }

// A sentence, whatever the help makes of it.
std::string Sentence(std::string text) {
  if (text.empty()) return text;
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  if (text.back() != '.') text += '.';
  return text;
}

// Lines that are indented are calls.
std::string NotesText(const std::string& notes) {
  std::string text, calls;
  const auto end_calls = [&] {
    if (!calls.empty()) text += RoffLines(calls);
    calls.clear();
  };
  for (size_t at = 0; at < notes.size();) {
    const size_t end = std::min(notes.find('\n', at), notes.size());
    const std::string line = notes.substr(at, end - at);
    at = end + 1;
    if (line.starts_with("  ")) {
      calls += (calls.empty() ? "" : "\n") + line.substr(2);
    } else {
      end_calls();
      text += RoffText(line) + "\n";
    }
  }
  end_calls();
  return text;
}

std::string Listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + RoffBold(name);
  return text;
}

// What its description does not say: limits, the default, what it goes with.
std::string Conditions(const OptionEntry& option) {
  std::vector<std::string> conditions;
  if (!option.limits.empty()) conditions.push_back(RoffText(option.limits));
  if (!option.default_value.empty())
    conditions.push_back("by default " + RoffBold(option.default_value));
  if (option.is_required && option.names.front().starts_with("-"))
    conditions.emplace_back("required");
  if (!option.needs.empty()) conditions.push_back("only with " + Listed(option.needs));
  if (!option.excludes.empty()) conditions.push_back("not with " + Listed(option.excludes));
  if (conditions.empty()) return "";
  std::string text = " (" + conditions.front();
  for (size_t i = 1; i < conditions.size(); ++i) text += "; " + conditions[i];
  return text + ")";
}

std::string OptionText(const OptionEntry& option) {
  std::string head = Listed(option.names);
  if (!option.value.empty()) head += " " + RoffItalic(option.value);
  return fmt::format(".TP\n{}\n{}{}\n", head, RoffText(option.description), Conditions(option));
}

std::string OptionsText(const std::vector<OptionEntry>& options) {
  std::string text;
  for (const OptionEntry& option : options) text += OptionText(option);
  return text;
}

std::string ArgumentsText(const std::vector<OptionEntry>& arguments) {
  std::string text;
  for (const OptionEntry& argument : arguments) {
    text += fmt::format(".TP\n{}\n{}{}\n", RoffItalic(argument.names.front()),
                        RoffText(argument.description), Conditions(argument));
  }
  return text;
}

std::string Usage(const std::string& program, const CommandEntry& command) {
  std::string text = RoffBold(program + (command.path.empty() ? "" : " ") + command.path);
  text += " [" + RoffItalic("OPTIONS") + "]";
  if (!command.commands.empty()) text += " " + RoffItalic("COMMAND") + " ...";
  for (const OptionEntry& argument : command.arguments) {
    const std::string name =
        RoffItalic(argument.names.front()) + (argument.takes_many ? "..." : "");
    text += argument.is_required ? " " + name : " [" + name + "]";
  }
  return text + "\n";
}

class PageWriter {
 public:
  PageWriter(std::string program, std::string version, std::string related,
             std::vector<CommandEntry> commands)
      : program_(std::move(program)),
        version_(std::move(version)),
        related_(std::move(related)),
        commands_(std::move(commands)) {}

  std::map<std::string, std::string> Write() const {
    std::map<std::string, std::string> pages;
    for (const CommandEntry& command : commands_) {
      pages[PageName(program_, command.path) + ".1"] = Page(command);
    }
    return pages;
  }

 private:
  std::string Page(const CommandEntry& command) const {
    const std::string name = PageName(program_, command.path);
    std::string heading = name;
    std::ranges::transform(heading, heading.begin(),
                           [](unsigned char c) { return std::toupper(c); });
    std::string title = command.title;
    while (title.ends_with('.')) title.pop_back();
    const CommandNotes& notes = command.notes;
    return fmt::format(".TH {} 1 \"\" \"{}\" \"Manual of {}\"\n", RoffText(heading),
                       RoffText(version_), RoffText(program_)) +
           Section("NAME", RoffText(name + " - " + title) + "\n") +
           Section("SYNOPSIS", Usage(program_, command)) +
           Section("DESCRIPTION", Paragraph(Sentence(command.title)) +
                                      (notes.text.empty() ? "" : ".PP\n" + NotesText(notes.text))) +
           Section("ARGUMENTS", ArgumentsText(command.arguments)) +
           Section("COMMANDS", CommandsText(command)) +
           Section("OPTIONS", OptionsText(command.options)) +
           Section("EXAMPLES", notes.examples.empty() ? "" : RoffLines(notes.examples)) +
           Section("ENVIRONMENT", Paragraph(notes.environment)) +
           Section("EXIT STATUS", Paragraph(notes.exit_status)) +
           Section("SEE ALSO", SeeAlso(command));
  }

  std::string CommandsText(const CommandEntry& command) const {
    std::vector<const CommandEntry*> listed;
    for (const std::string& name : command.commands)
      listed.push_back(&Below(command, name, commands_));
    // By groups, in the order of their first commands.
    std::vector<std::string> groups;
    for (const CommandEntry* below : listed) {
      if (std::ranges::count(groups, below->group) == 0) groups.push_back(below->group);
    }
    std::string text;
    for (const std::string& group : groups) {
      if (group != kDefaultGroup) text += fmt::format(".SS \"{}\"\n", RoffText(group));
      for (const CommandEntry* below : listed) {
        if (below->group == group) text += CommandText(*below);
      }
    }
    return text;
  }

  std::string CommandText(const CommandEntry& command) const {
    return fmt::format(".TP\n{}\n{}\nSee {}.\n", RoffBold(command.name),
                       RoffText(Sentence(command.title)),
                       Reference(PageName(program_, command.path)));
  }

  std::string SeeAlso(const CommandEntry& command) const {
    std::string text;
    if (!command.path.empty()) {
      text += Reference(program_) + ", ";
      if (const size_t space = command.path.rfind(' '); space != std::string::npos)
        text += Reference(PageName(program_, command.path.substr(0, space))) + ", ";
    }
    return text + Reference(related_) + "\n";
  }

  std::string program_;
  std::string version_;
  std::string related_;
  std::vector<CommandEntry> commands_;
};

}  // namespace

std::map<std::string, std::string> ManualPages(const Command& program, const std::string& version,
                                               const std::string& related) {
  return PageWriter(program.name(), version, related, CommandsOf(program, {})).Write();
}

void AddManual(Command& program, const std::string& version, const std::string& related) {
  const auto folder = std::make_shared<std::filesystem::path>();
  Command& command = program.AddCommand("manual", "Writes the manual pages into a folder.");
  command.Hide();
  command.AddOption("FOLDER", *folder, "where to").Required();
  command.OnRun([folder, version, related, &program] {
    std::error_code error;
    std::filesystem::create_directories(*folder, error);
    for (const auto& [name, text] : ManualPages(program, version, related)) {
      const std::filesystem::path file = *folder / name;
      if (!(std::ofstream(file) << text << std::flush)) {
        throw CallError(fmt::format("cannot write `{}`", file.string()));
      }
    }
    return 0;
  });
}

}  // namespace command_line
