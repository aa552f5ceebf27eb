// What the shells offer, with the scripts that are installed for them.
#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <sstream>
#include <thread>

#include "tests/runtime/trainer/child_process.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace {

using runtime::ProgramResult;
using runtime::RunProgram;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;

struct Shell {
  const char* name;
  const char* call;    // with which it runs a script
  const char* script;  // of the programs, with `@` for their name
};

// Otherwise tests are named by the bytes, which are addresses.
void PrintTo(const Shell& shell, std::ostream* stream) { *stream << shell.name; }

constexpr Shell kShells[] = {{"bash", "bash", "bash/@"},
                             {"zsh", "zsh -f", "zsh/_@"},
                             {"fish", "fish --no-config", "fish/@.fish"}};

class CompletionTest : public testing::TestWithParam<Shell> {
 protected:
  void SetUp() override {
    const std::string find = std::string("command -v ") + GetParam().name;
    if (RunProgram({"/bin/sh", "-c", find}).exit_status != 0) {
      GTEST_SKIP() << GetParam().name << " is not installed";
    }
    for (const char* name :
         {"walking.task", "two words.task", "notes.txt", "runs/x", "mine.toml"}) {
      std::filesystem::create_directories((folder_.path() / name).parent_path());
      std::ofstream(folder_.path() / name);
    }
  }

  std::string Path(const char* name) const { return (folder_.path() / name).string(); }

  // What the shell offers when the tab key is pressed behind `line`, sorted; folders without `/`.
  std::vector<std::string> Completed(const std::string& line) const {
    const std::string program = line.substr(0, line.find(' '));
    std::string script = GetParam().script;
    script.replace(script.find('@'), 1, program);
    const ProgramResult result = RunProgram(
        {"/usr/bin/env", "-C", folder_.path().string(), "HOME=" + home_.path().string(),
         "TERM=dumb", "LC_ALL=C.UTF-8", "PATH=" PROGRAMS ":/usr/bin:/bin", "/bin/sh", "-c",
         std::string("exec timeout 60 ") + GetParam().call + " \"$0\" \"$1\" \"$2\" <\"$3\"",
         std::string(SHELLS "/ask.") + GetParam().name, program, line, PAGES "/" + script});
    EXPECT_EQ(result.errors, "") << line;
    std::istringstream answer(result.output);
    std::vector<std::string> words;
    for (std::string word; std::getline(answer, word);) {
      if (word.ends_with('/')) word.pop_back();
      std::erase(word, '\\');  // as zsh writes spaces
      if (!word.empty()) words.push_back(word);
    }
    std::ranges::sort(words);
    words.erase(std::ranges::unique(words).begin(), words.end());
    return words;
  }

 private:
  runtime::TemporaryFolder folder_;
  runtime::TemporaryFolder home_;  // where fish writes
};

TEST_P(CompletionTest, OffersCommands) {
  EXPECT_THAT(Completed("taskc "),
              AllOf(IsSupersetOf({"build", "check", "explain"}), Not(Contains("manual"))));
  EXPECT_THAT(Completed("taskc ch"), ElementsAre("check"));
  EXPECT_THAT(Completed("trainer "), IsSupersetOf({"train", "ctl", "study"}));
  EXPECT_THAT(Completed("trainer ctl "),
              AllOf(IsSupersetOf({"status", "swap", "watch"}), Not(Contains("train"))));
}

TEST_P(CompletionTest, FollowsTheLinePastOptionsAndTheirValues) {
  EXPECT_THAT(Completed("trainer ctl --run x mod"), ElementsAre("module"));
  EXPECT_THAT(Completed("trainer ctl --run status mod"), ElementsAre("module"));
  EXPECT_THAT(Completed("trainer ctl module "), IsSupersetOf({"add", "remove"}));
}

// `resume` is a command of its own and one of `ctl`.
TEST_P(CompletionTest, OffersTheOptionsOfThatVeryCommand) {
  EXPECT_THAT(Completed("trainer resume --j"), IsSupersetOf({"--jobs", "--json"}));
  EXPECT_THAT(Completed("trainer ctl resume --j"), ElementsAre("--json"));
  EXPECT_THAT(Completed("trainer ctl swap --f"), ElementsAre("--forget"));
  EXPECT_THAT(Completed("taskc build --cac"), ElementsAre("--cache"));
  EXPECT_THAT(Completed("taskc check --cac"), IsEmpty());
  EXPECT_THAT(Completed("taskc check --form"), IsEmpty());  // hidden
}

TEST_P(CompletionTest, OffersWords) {
  EXPECT_THAT(Completed("trainer train --profile fast-"), ElementsAre("fast-tree"));
  EXPECT_THAT(Completed("trainer train --episodes "), IsEmpty());
  EXPECT_THAT(Completed("trainer agent show walking.task --format "),
              ElementsAre("dot", "text", "toml"));
  EXPECT_THAT(Completed("taskc check --color "), ElementsAre("always", "auto", "never"));
  EXPECT_THAT(Completed("taskc explain W070"), Contains("W0706"));
  EXPECT_THAT(Completed("taskc completion "), ElementsAre("bash", "fish", "zsh"));
}

TEST_P(CompletionTest, OffersNamesThatTheProgramKnows) {
  EXPECT_THAT(Completed("trainer train --robot "), IsSupersetOf({"humanoid", "quadruped"}));
  EXPECT_THAT(Completed("trainer robot show hum"), ElementsAre("humanoid"));
  EXPECT_THAT(Completed("trainer train --agent "), IsSupersetOf({"paper", "ppo", "mine.toml"}));
  EXPECT_THAT(Completed("taskc new walking --for hum"), ElementsAre("humanoid"));
}

TEST_P(CompletionTest, OffersWhatCanBeSet) {
  const std::string train = "trainer train " TASKS "/crawling.task ";
  EXPECT_THAT(Completed(train + "--set task."),
              ElementsAre("task.fall_penalty=", "task.turning_cost="));
  EXPECT_THAT(Completed(train + "--set learner.cl"), IsEmpty());
  EXPECT_THAT(Completed(train + "--agent ppo --set learner.cl"), ElementsAre("learner.clip="));
  EXPECT_THAT(Completed(train + "--set task.fall_penalty=2 --set task.t"),
              ElementsAre("task.turning_cost="));
  EXPECT_THAT(Completed("trainer train --set task.fall_penalty=2 w"), ElementsAre("walking.task"));
  EXPECT_THAT(Completed("trainer train --set task."), IsEmpty());               // of which task?
  EXPECT_THAT(Completed("trainer train walking.task --set task."), IsEmpty());  // it is empty
}

TEST_P(CompletionTest, OffersFilesAndFoldersInTheirPlaces) {
  EXPECT_THAT(Completed("trainer train w"), ElementsAre("walking.task"));
  EXPECT_THAT(Completed("taskc check t"), ElementsAre("two words.task"));
  EXPECT_THAT(Completed("taskc diff walking.task w"), ElementsAre("walking.task"));
  EXPECT_THAT(Completed("trainer show "), ElementsAre("runs"));
  EXPECT_THAT(Completed("taskc check --robots "), ElementsAre("runs"));
  EXPECT_THAT(Completed("trainer ctl swap task n"), ElementsAre("notes.txt"));
  EXPECT_THAT(Completed("trainer ctl swap n"), IsEmpty());
}

TEST_P(CompletionTest, OffersWhatTheRunIsMadeOf) {
  runtime::ChildProcess trainer({PROGRAMS "/trainer", "train", TASKS "/crawling.task", "--out",
                                 Path("run"), "--profile", "fast-tree", "--quiet", "--episodes",
                                 "1000000"});
  const std::string ctl = "trainer ctl --run run ";
  for (int i = 0; i < 600 && Completed(ctl + "swap ").empty(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  EXPECT_THAT(Completed(ctl + "swap "), ElementsAre("task"));
  EXPECT_THAT(Completed(ctl + "set task."), ElementsAre("task.fall_penalty", "task.turning_cost"));
  EXPECT_THAT(Completed(ctl + "get learner"), IsSupersetOf({"learner", "learner.temperature"}));
  EXPECT_THAT(Completed(ctl + "connect task.rew"), ElementsAre("task.reward"));
  EXPECT_THAT(Completed(ctl + "connect task.reward learner.rew"), ElementsAre("learner.reward"));
  EXPECT_THAT(Completed(ctl + "module remove fea"), ElementsAre("features"));
  EXPECT_THAT(Completed(ctl + "release "), IsEmpty());  // it has no goals
  EXPECT_THAT(Completed("trainer ctl --run runs set "), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(, CompletionTest, testing::ValuesIn(kShells),
                         [](const auto& shell) { return std::string(shell.param.name); });

// Bash hands over `--option=value` in three words.
TEST(BashCompletion, KnowsValuesBehindEqualsSigns) {
  const ProgramResult result =
      RunProgram({"/bin/bash", "-c",
                  "source " PAGES "/bash/trainer; COMP_WORDS=(trainer train --profile = fast-);"
                  "COMP_CWORD=4; _trainer; echo \"${COMPREPLY[@]}\""});
  EXPECT_EQ(result.output, "fast-tree\n");
}

TEST(BashCompletion, OffersNothingInTheMiddleOfASetting) {
  for (const char* words : {"(trainer train --set task.x =)", "(trainer train --set task.x = w)"}) {
    const ProgramResult result = RunProgram(
        {"/bin/bash", "-c",
         std::string("source " PAGES "/bash/trainer; COMP_WORDS=") + words +
             "; COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _trainer; echo ${#COMPREPLY[@]}"});
    EXPECT_EQ(result.output, "0\n") << words;
  }
}

TEST(Completion, KnowsThreeShells) {
  for (const char* program : {PROGRAMS "/taskc", PROGRAMS "/trainer"}) {
    EXPECT_EQ(RunProgram({program, "completion", "tcsh"}).exit_status, 2);
    const ProgramResult without = RunProgram({program, "completion"});
    EXPECT_EQ(without.exit_status, 2);
    EXPECT_THAT(without.errors, testing::HasSubstr("for which shell: bash, zsh or fish?"));
    EXPECT_EQ(RunProgram({program, "completion", "--names", "MOON"}).exit_status, 2);
  }
}

}  // namespace
