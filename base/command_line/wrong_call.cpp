#include "base/command_line/wrong_call.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <vector>

#include "base/text/nearest_name.h"

namespace command_line {
namespace {

// A command of the line that is understood: "trainer ctl" of `trainer ctl swop`.
struct Chosen {
  const CLI::App* app;
  std::string line;
};

// From the program to the last command.
std::vector<Chosen> ChosenOf(const CLI::App& program) {
  std::vector<Chosen> chosen = {{&program, program.get_name()}};
  while (!chosen.back().app->get_subcommands().empty()) {
    const CLI::App* next = chosen.back().app->get_subcommands().front();
    chosen.push_back({next, chosen.back().line + " " + next->get_name()});
  }
  return chosen;
}

std::vector<std::string> CommandsOf(const CLI::App& app) {
  std::vector<std::string> names;
  const auto is_shown = [](const CLI::App* command) { return !command->get_group().empty(); };
  for (const CLI::App* command : app.get_subcommands(is_shown)) {
    names.push_back(command->get_name());
  }
  return names;
}

std::vector<std::string> OptionsOf(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::string NoSuchCommand(const Chosen& chosen, const std::string& word) {
  const std::optional<std::string> nearest = text::NearestName(word, CommandsOf(*chosen.app));
  return fmt::format("there is no command `{}`{}", word,
                     nearest ? fmt::format("; did you mean `{} {}`?", chosen.line, *nearest) : "");
}

std::string NoSuchOption(const Chosen& chosen, const std::string& word) {
  const std::string name = word.substr(0, word.find('='));
  const std::optional<std::string> nearest = text::NearestName(name, OptionsOf(*chosen.app));
  return fmt::format("`{}` has no option `{}`{}", chosen.line, name,
                     nearest ? fmt::format("; did you mean `{}`?", *nearest) : "");
}

// An option, or, where a command should stand, another word; "" where there is none. What follows
// an unknown option may be its value.
std::string UnknownWord(const Chosen& chosen) {
  const std::vector<std::string> unknown = chosen.app->remaining();
  const bool wants_command =
      chosen.app->get_subcommands().empty() && !CommandsOf(*chosen.app).empty();
  if (wants_command && !unknown.empty()) return unknown.front();
  const auto option =
      std::ranges::find_if(unknown, [](const std::string& word) { return word.starts_with("-"); });
  return option == unknown.end() ? "" : *option;
}

}  // namespace

std::string WhatIsWrong(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<Chosen> line = ChosenOf(app);
  const std::vector<std::string> commands = CommandsOf(*line.back().app);
  // Only where a word is left over, or something is missing in its place.
  const bool is_of_words = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr ||
                           dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  if (is_of_words) {
    for (const Chosen& chosen : line) {
      if (const std::string word = UnknownWord(chosen); !word.empty()) {
        return word.starts_with("-") ? NoSuchOption(chosen, word) : NoSuchCommand(chosen, word);
      }
    }
    if (!commands.empty()) return fmt::format("expected a command: {}", fmt::join(commands, ", "));
  }
  std::string message = error.what();
  std::ranges::replace(message, '\n', ' ');
  return message;
}

}  // namespace command_line
