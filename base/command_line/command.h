// A program's command line: its commands with their options and arguments, each declared once.
// Help, error messages, manual pages and shell completion follow from the declarations. CLI11 does
// the work; its templates are compiled in this folder only.
//
//   Command program("trainer", "Trains a simulated robot in a task.");
//   Command& train = program.AddCommand("train", "Starts a run.");
//   train.AddOption("TASK", options.task, "a .task file").Required();
//   train.AddOption("--runs", options.runs, "how many runs").Range(1, 100).ShowDefault();
//   train.OnRun([&] { return Train(options); });
//   if (const auto run = program.Parse(argc, argv)) return run();
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace command_line {

// The program was called wrongly; what() says how, in one line.
class CallError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// An option, flag or argument that was just declared: these calls say more about it. A handle; what
// it stands for belongs to the command.
class Option {
 public:
  Option& Required();
  // What the help shows for the value: "DIR", "FILE.md|FILE.html"; "" for nothing. From it follows
  // what shells complete (completed_value.h).
  Option& ValueName(const std::string& name);
  // The help shows the value that the variable has now.
  Option& ShowDefault();
  // Left out of the help and of completion.
  Option& Hidden();

  // Numbers from `low` to `high`, both included.
  Option& Range(int low, int high) { return Range(int64_t{low}, int64_t{high}); }
  Option& Range(int64_t low, int64_t high);
  Option& Range(double low, double high);
  Option& NonNegative();
  Option& Positive();
  // One of these words, which become the value's name: "text|json".
  Option& OneOf(const std::vector<std::string>& words);

  // How many values a list takes: from `least` to `most`, where 0 means any number.
  Option& Count(int least, int most);
  // Each value of a list needs the option's name before it, so that an argument may follow.
  Option& OneAtATime();

  // Only together with `other`.
  Option& Needs(Option other);
  // Not together with `other`, nor `other` together with this.
  Option& Excludes(Option other);

 private:
  friend class Command;
  explicit Option(CLI::Option* option) : option_(option) {}

  CLI::Option* option_;
};

// What the help and the manual page of a command say below its options; each may be "".
struct CommandNotes {
  std::string examples;     // calls, one in a line, each with a comment
  std::string text;         // whatever else is to be known
  std::string environment;  // variables, and what they are for
  std::string exit_status;  // "0 success, 1 ..."
};

// A program, or one of its commands.
class Command {
 public:
  // A program. All of it is declared before Parse().
  Command(const std::string& name, const std::string& description);
  ~Command();
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;

  const std::string& name() const;
  const Command& program() const;
  const std::vector<std::unique_ptr<Command>>& commands() const { return commands_; }
  // Null where there is no such command.
  Command* FindCommand(const std::string& name) const;

  // One of the commands below must then be named: this one does nothing by itself. A new command
  // begins with the group and the exit status that this one has at that moment.
  Command& AddCommand(const std::string& name, const std::string& description);
  // The heading under which the help of the command above lists this one.
  void Group(const std::string& heading);
  // Left out of the help, of completion and of the manual.
  void Hide();
  void Examples(const std::string& calls);
  void Notes(const std::string& text);
  void Environment(const std::string& variables);
  void ExitStatus(const std::string& meaning);
  const CommandNotes& notes() const { return notes_; }
  // Adds `--version`, which prints `text`.
  void Version(const std::string& text);

  // `names`: "-o,--output", or "FILE" for an argument without a name. `value` holds the default,
  // and must outlive the command. Values: std::string, std::filesystem::path, int, int64_t,
  // uint16_t, uint64_t, double, std::optional<int64_t>, std::vector<std::string>.
  template <class Value>
  Option AddOption(const std::string& names, Value& value, const std::string& description);
  Option AddFlag(const std::string& names, bool& value, const std::string& description);

  // The same for what is not just stored: Parse() calls `set`, which may throw CallError, with the
  // value. Values: std::string, int64_t, double, std::vector<std::string>.
  template <class Value>
  Option OnOption(const std::string& names, std::function<void(const Value&)> set,
                  const std::string& description);
  Option OnFlag(const std::string& names, std::function<void()> set,
                const std::string& description);
  // Takes all words that nothing else takes, also those that begin with `-`. `set` may throw
  // CallError.
  void OnWords(std::function<void(const std::vector<std::string>&)> set);

  // What these words begin with, for completion and the manual.
  void FirstWord(const std::string& name, const std::string& description);
  const std::optional<std::pair<std::string, std::string>>& first_word() const {
    return first_word_;
  }

  // What the command does; returns the exit status.
  void OnRun(std::function<int()> action);

  // Of a program: reads its command line. Returns what the named command does; null where help or
  // the version was asked for, which is then printed. Throws CallError.
  std::function<int()> Parse(int argc, const char* const* argv);

  // For the rest of this folder.
  const CLI::App& app() const { return *app_; }

 private:
  Command(const Command& parent, CLI::App* app);

  void ShowNotes();

  const Command* const parent_;                  // null: this is the program
  const std::unique_ptr<CLI::App> program_app_;  // owns those of all commands
  CLI::App* const app_;
  std::vector<std::unique_ptr<Command>> commands_;
  CommandNotes notes_;
  std::optional<std::pair<std::string, std::string>> first_word_;  // name and description
  std::function<int()> action_;
};

}  // namespace command_line
