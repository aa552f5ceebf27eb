#include "base/command_line/command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "base/command_line/wrong_call.h"

namespace command_line {
namespace {

// Instead of CLI11's own, whose messages end in the 300 digits of the largest number. `shown`: in
// the help.
CLI::Validator NumberThat(bool (*fits)(double), const char* shown, const char* expected) {
  const auto check = [fits, expected](std::string& word) -> std::string {
    double number = 0;
    const bool is_number = CLI::detail::lexical_cast(word, number) && std::isfinite(number);
    return is_number && fits(number) ? "" : fmt::format("expected {}, not `{}`", expected, word);
  };
  return CLI::Validator(check, shown);
}

// All lines but the first by two columns.
std::string Indented(std::string lines) {
  for (size_t at = lines.find('\n'); at != std::string::npos; at = lines.find('\n', at + 3)) {
    lines.insert(at + 1, "  ");
  }
  return lines;
}

}  // namespace

Option& Option::Required() {
  option_->required();
  return *this;
}

Option& Option::ValueName(const std::string& name) {
  option_->type_name(name);
  return *this;
}

Option& Option::ShowDefault() {
  option_->capture_default_str();
  return *this;
}

Option& Option::Hidden() {
  option_->group("");
  return *this;
}

Option& Option::Range(int64_t low, int64_t high) {
  option_->check(CLI::Range(low, high));
  return *this;
}

Option& Option::Range(double low, double high) {
  option_->check(CLI::Range(low, high));
  return *this;
}

Option& Option::NonNegative() {
  const auto fits = [](double number) { return number >= 0; };
  option_->check(NumberThat(fits, "NONNEGATIVE", "a number of 0 or more"));
  return *this;
}

Option& Option::Positive() {
  const auto fits = [](double number) { return number > 0; };
  option_->check(NumberThat(fits, "POSITIVE", "a positive number"));
  return *this;
}

Option& Option::OneOf(const std::vector<std::string>& words) {
  // Without a description of the check, which would repeat the words in the help.
  option_->type_name(fmt::format("{}", fmt::join(words, "|")))
      ->check(CLI::IsMember(words).description(""));
  return *this;
}

Option& Option::Count(int least, int most) {
  option_->expected(least, most == 0 ? CLI::detail::expected_max_vector_size : most);
  return *this;
}

Option& Option::OneAtATime() {
  option_->allow_extra_args(false);
  return *this;
}

Option& Option::Needs(Option other) {
  option_->needs(other.option_);
  return *this;
}

Option& Option::Excludes(Option other) {
  option_->excludes(other.option_);
  return *this;
}

Command::Command(const std::string& name, const std::string& description)
    : parent_(nullptr),
      program_app_(std::make_unique<CLI::App>(description, name)),
      app_(program_app_.get()) {}

Command::Command(const Command& parent, CLI::App* app) : parent_(&parent), app_(app) {
  ExitStatus(parent.notes_.exit_status);
}

Command::~Command() = default;

const std::string& Command::name() const { return app_->get_name(); }

const Command& Command::program() const { return parent_ == nullptr ? *this : parent_->program(); }

Command* Command::FindCommand(const std::string& name) const {
  const auto found =
      std::ranges::find_if(commands_, [&](const auto& command) { return command->name() == name; });
  return found == commands_.end() ? nullptr : found->get();
}

Command& Command::AddCommand(const std::string& name, const std::string& description) {
  app_->require_subcommand(1);
  CLI::App* app = app_->add_subcommand(name, description);
  commands_.push_back(std::unique_ptr<Command>(new Command(*this, app)));
  return *commands_.back();
}

void Command::Group(const std::string& heading) { app_->group(heading); }

void Command::Hide() { app_->group(""); }

void Command::Examples(const std::string& calls) {
  notes_.examples = calls;
  ShowNotes();
}

void Command::Notes(const std::string& text) {
  notes_.text = text;
  ShowNotes();
}

void Command::Environment(const std::string& variables) {
  notes_.environment = variables;
  ShowNotes();
}

void Command::ExitStatus(const std::string& meaning) {
  notes_.exit_status = meaning;
  ShowNotes();
}

void Command::ShowNotes() {
  std::string footer;
  const auto add = [&](const std::string& heading, const std::string& text) {
    if (!text.empty()) footer += (footer.empty() ? "" : "\n") + heading + text;
  };
  add("Examples:\n  ", Indented(notes_.examples));
  add("", notes_.text);
  add("Environment: ", notes_.environment);
  add("Exit status: ", notes_.exit_status);
  app_->footer(footer);
}

void Command::Version(const std::string& text) {
  app_->set_version_flag("--version", text, "print the version and exit");
}

template <class Value>
Option Command::AddOption(const std::string& names, Value& value, const std::string& description) {
  return Option(app_->add_option(names, value, description));
}

template Option Command::AddOption(const std::string&, std::string&, const std::string&);
template Option Command::AddOption(const std::string&, std::filesystem::path&, const std::string&);
template Option Command::AddOption(const std::string&, int&, const std::string&);
template Option Command::AddOption(const std::string&, int64_t&, const std::string&);
template Option Command::AddOption(const std::string&, uint16_t&, const std::string&);
template Option Command::AddOption(const std::string&, uint64_t&, const std::string&);
template Option Command::AddOption(const std::string&, double&, const std::string&);
template Option Command::AddOption(const std::string&, std::optional<int64_t>&, const std::string&);
template Option Command::AddOption(const std::string&, std::vector<std::string>&,
                                   const std::string&);

Option Command::AddFlag(const std::string& names, bool& value, const std::string& description) {
  return Option(app_->add_flag(names, value, description));
}

template <class Value>
Option Command::OnOption(const std::string& names, std::function<void(const Value&)> set,
                         const std::string& description) {
  return Option(app_->add_option_function<Value>(names, set, description));
}

template Option Command::OnOption(const std::string&, std::function<void(const std::string&)>,
                                  const std::string&);
template Option Command::OnOption(const std::string&, std::function<void(const int64_t&)>,
                                  const std::string&);
template Option Command::OnOption(const std::string&, std::function<void(const double&)>,
                                  const std::string&);
template Option Command::OnOption(const std::string&,
                                  std::function<void(const std::vector<std::string>&)>,
                                  const std::string&);

Option Command::OnFlag(const std::string& names, std::function<void()> set,
                       const std::string& description) {
  return Option(app_->add_flag_callback(names, std::move(set), description));
}

void Command::OnWords(std::function<void(const std::vector<std::string>&)> set) {
  app_->allow_extras();
  app_->parse_complete_callback([app = app_, set = std::move(set)] { set(app->remaining()); });
}

void Command::FirstWord(const std::string& name, const std::string& description) {
  first_word_ = {name, description};
}

void Command::OnRun(std::function<int()> action) { action_ = std::move(action); }

std::function<int()> Command::Parse(int argc, const char* const* argv) {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::Success& wish) {  // --help, --version
    app_->exit(wish);
    return nullptr;
  } catch (const CLI::ParseError& error) {
    throw CallError(WhatIsWrong(*app_, error));
  }
  const Command* named = this;
  while (!named->commands_.empty()) {
    named = named->FindCommand(named->app_->get_subcommands().front()->get_name());
  }
  return named->action_;
}

}  // namespace command_line
