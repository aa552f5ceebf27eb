#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "tests/compiler/driver/taskc_process.h"

namespace compiler {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

// One line on standard error, nothing on standard output, status 2.
void ExpectRefusal(const Outcome& outcome, const std::string& part) {
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.error, AllOf(StartsWith("taskc: "), HasSubstr(part)));
  EXPECT_EQ(std::ranges::count(outcome.error, '\n'), 1) << outcome.error;
}

TEST(CommandLine, ExplainsItself) {
  TaskcProcess taskc;
  Outcome help = taskc.Run("--help");
  EXPECT_EQ(help.status, 0);
  EXPECT_EQ(help.error, "");
  for (const char* part : {"build", "check", "emit", "Exit status", "TASKC_CACHE"}) {
    EXPECT_THAT(help.out, HasSubstr(part));
  }
  EXPECT_THAT(taskc.Run("build --help").out, AllOf(HasSubstr("--cache DIR"), HasSubstr("FILE.so")));
  EXPECT_THAT(taskc.Run("check --help").out, HasSubstr("--robots DIR"));
  EXPECT_EQ(taskc.Run("--version").out, "taskc " TASKC_VERSION "\n");
}

// Every verb that the help lists tells of itself, with examples.
TEST(CommandLine, ExplainsEachVerb) {
  TaskcProcess taskc;
  std::istringstream help(taskc.Run("--help").out);
  int verbs = 0;
  std::string line;
  while (std::getline(help, line) && line != "Subcommands:") {
  }
  for (std::string verb; std::getline(help, line) && std::istringstream(line) >> verb; ++verbs) {
    EXPECT_THAT(taskc.Run(verb + " --help").out,
                AllOf(HasSubstr("Examples:\n  taskc " + verb), HasSubstr("--version")));
    EXPECT_EQ(taskc.Run(verb + " --version").out, "taskc " TASKC_VERSION "\n");
  }
  EXPECT_GE(verbs, 3);
}

TEST(CommandLine, RefusesWhatItDoesNotUnderstand) {
  TaskcProcess taskc;
  ExpectRefusal(taskc.Run(""), "expected a command: new, build, check");
  ExpectRefusal(taskc.Run("biuld x.task"), "no command `biuld`; did you mean `taskc build`?");
  ExpectRefusal(taskc.Run("build"), "FILE.task");
  ExpectRefusal(taskc.Run("build a.task b.task"), "b.task");
  ExpectRefusal(taskc.Run("check --fast a.task"), "`taskc check` has no option `--fast`");
  ExpectRefusal(taskc.Run("check --fromat json a.task"), "did you mean `--format`?");
  ExpectRefusal(taskc.Run("build a.task -o"), "output");
  ExpectRefusal(taskc.Run("lsp --stdio=maybe"), "--stdio = maybe");
}

TEST(CommandLine, SaysWhichFileCannotBeRead) {
  TaskcProcess taskc;
  taskc.Write("folder/file", "");
  ExpectRefusal(taskc.Run("check absent.task"), "`absent.task`: No such file or directory");
  ExpectRefusal(taskc.Run("build folder"), "`folder`");
  ExpectRefusal(taskc.Run("emit ''"), "cannot read");
}

TEST(CommandLine, SaysThatItsOutputIsLost) {
  TaskcProcess taskc;
  taskc.Write("good.task", kGoodTask);
  Outcome outcome = taskc.Run("emit good.task >/dev/full");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.error, HasSubstr("No space left on device"));
}

}  // namespace
}  // namespace compiler
