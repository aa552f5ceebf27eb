#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "compiler/toolchain/file_io.h"
#include "tests/compiler/driver/taskc_process.h"

namespace compiler {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;

// What bash offers when the tab key is pressed behind `line`, in the folder of `taskc`.
std::vector<std::string> Completed(const TaskcProcess& taskc, const std::string& line) {
  taskc.Write("ask.sh", R"sh(eval "$("$1" completion bash)"
read -ra COMP_WORDS <<<"$2"
[[ $2 == *' ' ]] && COMP_WORDS+=('')
COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
_taskc
printf '%s\n' "${COMPREPLY[@]}"
)sh");
  std::string command =
      "cd '" + taskc.path("").string() + "' && bash ask.sh '" TASKC "' '" + line + "' >answer 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0);
  std::istringstream answer(ReadWholeFile(taskc.path("answer")).value());
  std::vector<std::string> words;
  for (std::string word; std::getline(answer, word);) {
    if (!word.empty()) words.push_back(word);
  }
  std::ranges::sort(words);
  return words;
}

TEST(Completion, OffersVerbsInBash) {
  TaskcProcess taskc;
  EXPECT_THAT(Completed(taskc, "taskc "), IsSupersetOf({"build", "check", "explain", "--help"}));
  EXPECT_THAT(Completed(taskc, "taskc ch"), ElementsAre("check"));
}

TEST(Completion, OffersTheOptionsOfAVerbInBash) {
  TaskcProcess taskc;
  EXPECT_THAT(Completed(taskc, "taskc check --"),
              IsSupersetOf({"--json", "--sarif", "--color", "--robots", "--help"}));
  EXPECT_THAT(Completed(taskc, "taskc check --form"), IsEmpty());
  EXPECT_THAT(Completed(taskc, "taskc build --cac"), ElementsAre("--cache"));
  EXPECT_THAT(Completed(taskc, "taskc check --cac"), IsEmpty());
}

TEST(Completion, OffersValuesInBash) {
  TaskcProcess taskc;
  taskc.Write("walking.task", "");
  taskc.Write("notes.txt", "");
  taskc.Write("two words.task", "");
  taskc.Write("more/x.task", "");
  EXPECT_THAT(Completed(taskc, "taskc check --color "), ElementsAre("always", "auto", "never"));
  EXPECT_THAT(Completed(taskc, "taskc explain W070"), Contains("W0706"));
  EXPECT_THAT(Completed(taskc, "taskc completion "), ElementsAre("bash", "fish", "zsh"));
  std::vector<std::string> files = Completed(taskc, "taskc check ");
  EXPECT_THAT(files, IsSupersetOf({"more", "two words.task", "walking.task"}));
  EXPECT_THAT(files, Not(Contains("notes.txt")));
  EXPECT_THAT(Completed(taskc, "taskc check --robots "), Not(Contains("walking.task")));
}

// The other shells may not be there: their scripts name what bash's does.
TEST(Completion, NamesAllVerbsForEveryShell) {
  TaskcProcess taskc;
  std::vector<std::string> verbs = Completed(taskc, "taskc ");
  for (const char* shell : {"zsh", "fish"}) {
    Outcome outcome = taskc.Run(std::string("completion ") + shell);
    EXPECT_EQ(outcome.status, 0);
    for (const std::string& verb : verbs) {
      if (verb.starts_with("-")) continue;
      EXPECT_THAT(outcome.out, HasSubstr(verb)) << shell;
    }
    EXPECT_THAT(outcome.out, HasSubstr("auto always never"));
  }
}

TEST(Completion, KnowsThreeShells) {
  TaskcProcess taskc;
  EXPECT_EQ(taskc.Run("completion tcsh").status, 2);
  EXPECT_EQ(taskc.Run("completion").status, 2);
}

}  // namespace
}  // namespace compiler
