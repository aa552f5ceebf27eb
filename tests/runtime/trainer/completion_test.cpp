#include <algorithm>
#include <fstream>
#include <sstream>

#include "tests/runtime/trainer/trainer_test.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;

class CompletionTest : public TrainerTest {
 protected:
  // What bash offers when the tab key is pressed behind `line`, in a folder of the test's own.
  std::vector<std::string> Completed(const std::string& line) const {
    std::ofstream(folder() / "ask.sh") << R"sh(cd "$3"
eval "$("$1" completion bash)"
read -ra COMP_WORDS <<<"$2"
[[ $2 == *' ' ]] && COMP_WORDS+=('')
COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
_trainer
printf '%s\n' "${COMPREPLY[@]}"
)sh";
    const ProgramResult result =
        RunProgram({"/bin/bash", (folder() / "ask.sh").string(), TRAINER, line, folder().string()});
    EXPECT_EQ(result.errors, "");
    std::istringstream answer(result.output);
    std::vector<std::string> words;
    for (std::string word; std::getline(answer, word);) {
      if (!word.empty()) words.push_back(word);
    }
    std::ranges::sort(words);
    return words;
  }
};

TEST_F(CompletionTest, OffersCommandsOfCommandsInBash) {
  EXPECT_THAT(Completed("trainer "), IsSupersetOf({"train", "ctl", "study", "--help"}));
  EXPECT_THAT(Completed("trainer ctl "),
              AllOf(IsSupersetOf({"status", "swap", "watch", "--run"}), Not(Contains("train"))));
  EXPECT_THAT(Completed("trainer ctl --run x mod"), ElementsAre("module"));
  EXPECT_THAT(Completed("trainer ctl module "), IsSupersetOf({"add", "remove"}));
}

// `resume` is a command of its own and one of `ctl`.
TEST_F(CompletionTest, OffersTheOptionsOfThatVeryCommandInBash) {
  EXPECT_THAT(Completed("trainer resume --"), Contains("--jobs"));
  EXPECT_THAT(Completed("trainer ctl resume --"), Not(Contains("--jobs")));
  EXPECT_THAT(Completed("trainer ctl swap --f"), ElementsAre("--forget"));
}

TEST_F(CompletionTest, OffersValuesInBash) {
  for (const char* name : {"walking.task", "notes.txt", "runs/x"}) {
    std::filesystem::create_directories((folder() / name).parent_path());
    std::ofstream(folder() / name);
  }
  EXPECT_THAT(Completed("trainer train "),
              AllOf(IsSupersetOf({"walking.task", "runs"}), Not(Contains("notes.txt"))));
  EXPECT_THAT(Completed("trainer train --profile fast-"), ElementsAre("fast-tree"));
  EXPECT_THAT(Completed("trainer train --episodes "), IsEmpty());
  EXPECT_THAT(Completed("trainer show "), ElementsAre("runs"));
  EXPECT_THAT(Completed("trainer agent show walking.task --format "),
              ElementsAre("dot", "text", "toml"));
}

// The other shells may not be there: their scripts name what bash's does.
TEST_F(CompletionTest, NamesAllCommandsForEveryShell) {
  std::vector<std::string> commands = Completed("trainer ");
  std::ranges::copy(Completed("trainer ctl "), std::back_inserter(commands));
  for (const char* shell : {"zsh", "fish"}) {
    const ProgramResult script = Trainer({"completion", shell});
    EXPECT_EQ(script.exit_status, 0);
    for (const std::string& command : commands) {
      if (command.starts_with("-")) continue;
      EXPECT_THAT(script.output, HasSubstr(command)) << shell;
    }
    EXPECT_THAT(script.output, HasSubstr("fast-tree"));
  }
  EXPECT_EQ(Trainer({"completion", "tcsh"}).exit_status, 2);
}

}  // namespace
}  // namespace runtime
