#include "base/command_line/command.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <optional>

#include "base/command_line/completion.h"
#include "base/command_line/manual.h"

namespace command_line {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

struct Options {
  std::filesystem::path task;
  std::string format = "text";
  std::optional<int64_t> episodes;
  int runs = 1;
  bool json = false;
  std::vector<std::string> settings;
  std::vector<std::string> order;
};

// A small program with a command of each kind.
class CommandTest : public testing::Test {
 protected:
  CommandTest() {
    program_.Version("robots 1.0");
    program_.ExitStatus("0 done.");
    Command& train = program_.AddCommand("train", "Trains a robot.");
    train.AddOption("TASK", options_.task, "a .task file").Required();
    train.AddOption("--runs", options_.runs, "how many runs").Range(1, 100).ShowDefault();
    train.AddOption("--episodes", options_.episodes, "of each run").NonNegative();
    train.AddOption("--set", options_.settings, "a parameter").OneAtATime();
    train.AddOption("--order", options_.order, "the best first").Count(2, 0).ValueName("RUN");
    Option json = train.AddFlag("--json", options_.json, "print JSON");
    train.AddOption("--format", options_.format, "of the report")
        .OneOf({"text", "json"})
        .Excludes(json);
    train.AddOption("--old", options_.format, "").Hidden();
    train.OnRun([] { return 7; });

    Command& module = program_.AddCommand("module", "Changes modules.");
    Command& add = module.AddCommand("add", "Adds one.");
    add.Examples("robots module add x  # one\nrobots module add y");
    add.Notes("As many as you like.");
    add.ExitStatus("0 added.");
    add.OnWords([this](const std::vector<std::string>& words) {
      if (words.empty()) throw CallError("which module?");
      words_ = words;
    });
    add.OnRun([] { return 8; });
  }

  std::function<int()> Parse(std::vector<const char*> words) {
    words.insert(words.begin(), "robots");
    return program_.Parse(static_cast<int>(words.size()), words.data());
  }

  std::string Printed(const std::vector<const char*>& words) {
    testing::internal::CaptureStdout();
    const bool has_action = Parse(words) != nullptr;
    EXPECT_FALSE(has_action);
    return testing::internal::GetCapturedStdout();
  }

  std::string Error(const std::vector<const char*>& words) {
    try {
      Parse(words);
    } catch (const CallError& error) {
      return error.what();
    }
    return "";
  }

  Options options_;
  std::vector<std::string> words_;
  Command program_{"robots", "Trains robots."};
};

TEST_F(CommandTest, ReturnsWhatTheNamedCommandDoes) {
  EXPECT_EQ(Parse({"train", "walk.task"})(), 7);
  EXPECT_EQ(Parse({"module", "add", "x"})(), 8);
}

TEST_F(CommandTest, FillsOptionsAndKeepsDefaults) {
  Parse({"train", "--runs", "3", "--set", "a=1", "walk.task", "--set", "b=2", "--order", "x", "y"});
  EXPECT_EQ(options_.task, "walk.task");
  EXPECT_EQ(options_.runs, 3);
  EXPECT_EQ(options_.episodes, std::nullopt);
  EXPECT_FALSE(options_.json);
  EXPECT_THAT(options_.settings, ElementsAre("a=1", "b=2"));
  EXPECT_THAT(options_.order, ElementsAre("x", "y"));
}

TEST_F(CommandTest, SaysWhatIsWrong) {
  EXPECT_EQ(Error({}), "expected a command: train, module");
  EXPECT_EQ(Error({"trian"}), "there is no command `trian`; did you mean `robots train`?");
  EXPECT_EQ(Error({"train", "walk.task", "--run=3"}),
            "`robots train` has no option `--run`; did you mean `--runs`?");
  EXPECT_EQ(Error({"train", "walk.task", "--runs", "101"}),
            "--runs: Value 101 not in range 1 to 100");
  EXPECT_EQ(Error({"train", "walk.task", "--episodes", "-1"}),
            "--episodes: expected a number of 0 or more, not `-1`");
  EXPECT_EQ(Error({"train", "walk.task", "--format", "xml"}), "--format: xml not in {text,json}");
  EXPECT_EQ(Error({"train", "walk.task", "--format", "text", "--json"}),
            "--json excludes --format");
  EXPECT_EQ(Error({"train", "walk.task", "--order", "x"}),
            "--order: At least 2 required but received 1");
  EXPECT_EQ(Error({"train"}), "TASK is required");
}

TEST_F(CommandTest, PassesOnWhatADeclarationSaysOfAValue) {
  EXPECT_EQ(Error({"module", "add"}), "which module?");
}

TEST_F(CommandTest, TakesAllOtherWords) {
  Parse({"module", "add", "x", "=", "-3", "->"});
  EXPECT_THAT(words_, ElementsAre("x", "=", "-3", "->"));
}

TEST_F(CommandTest, PrintsHelpAndVersion) {
  EXPECT_EQ(Printed({"--version"}), "robots 1.0\n");
  const std::string help = Printed({"train", "--help"});
  EXPECT_THAT(help, HasSubstr("--runs INT:INT in [1 - 100]=1"));
  EXPECT_THAT(help, HasSubstr("--format text|json"));
  EXPECT_THAT(help, Not(HasSubstr("--old")));
}

TEST_F(CommandTest, ExitStatusIsTheProgramsUnlessACommandHasItsOwn) {
  EXPECT_THAT(Printed({"train", "--help"}), HasSubstr("Exit status: 0 done."));
  const std::string help = Printed({"module", "add", "--help"});
  EXPECT_THAT(help, HasSubstr("Examples:\n  robots module add x  # one\n  robots module add y\n"
                              "As many as you like.\nExit status: 0 added.\n"));
  EXPECT_THAT(help, Not(HasSubstr("0 done")));
}

TEST_F(CommandTest, SaysNothingOfWhatIsHidden) {
  Command& secret = program_.AddCommand("secret", "Not for everybody.");
  secret.Hide();
  secret.OnRun([] { return 9; });
  EXPECT_EQ(Parse({"secret"})(), 9);
  EXPECT_THAT(Printed({"--help"}), Not(HasSubstr("secret")));
  EXPECT_EQ(Error({}), "expected a command: train, module");
  EXPECT_THAT(Completion("bash", program_), Not(HasSubstr("secret")));
  EXPECT_FALSE(ManualPages(program_, "robots 1.0", "others").contains("robots-secret.1"));
}

}  // namespace
}  // namespace command_line
