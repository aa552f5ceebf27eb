// Whatever goes wrong inside taskc, a folder tells those who are to look into it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compiler/toolchain/file_io.h"
#include "tests/compiler/driver/taskc_process.h"

namespace compiler {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// The folder that the message names.
std::filesystem::path FolderIn(const std::string& error) {
  const size_t begin = error.find("folder ") + 7;
  return error.substr(begin, error.find('\n', begin) - begin);
}

// A C++ compiler that sends a signal to taskc stands for a crash in the middle of its work.
Outcome CrashWith(const TaskcProcess& taskc, const std::string& signal) {
  taskc.Write("good.task", kGoodTask);
  taskc.Write("kill", "#!/bin/sh\nkill -" + signal + " $PPID\nsleep 5\n");
  std::filesystem::permissions(taskc.path("kill"), std::filesystem::perms::owner_all);
  return taskc.Run("build good.task", "CXX='" + taskc.path("kill").string() + "' TMPDIR='" +
                                          taskc.path("").string() + "'");
}

TEST(Crash, LeavesAFolderWithAllThatIsKnown) {
  for (const char* signal : {"SEGV", "ABRT"}) {
    TaskcProcess taskc;
    Outcome outcome = CrashWith(taskc, signal);
    EXPECT_EQ(outcome.status, 3);
    EXPECT_THAT(outcome.error, AllOf(HasSubstr("internal error"), HasSubstr("please report")));
    std::filesystem::path folder = FolderIn(outcome.error);
    EXPECT_EQ(ReadWholeFile(folder / "good.task"), kGoodTask);
    EXPECT_THAT(ReadWholeFile(folder / "report.txt").value_or("nothing"),
                AllOf(HasSubstr("taskc " TASKC_VERSION "\n"), HasSubstr("taskc build good.task\n"),
                      HasSubstr("crash: signal")));
  }
}

TEST(Crash, AnExceptionIsReportedLikewise) {
  TaskcProcess taskc;
  taskc.Write("good.task", kGoodTask);
  taskc.Write("refuse", "#!/bin/sh\nexit 1\n");
  std::filesystem::permissions(taskc.path("refuse"), std::filesystem::perms::owner_all);
  Outcome outcome = taskc.Run("build good.task", "CXX='" + taskc.path("refuse").string() + "'");
  EXPECT_EQ(outcome.status, 3);
  EXPECT_THAT(ReadWholeFile(FolderIn(outcome.error) / "report.txt").value_or("nothing"),
              AllOf(HasSubstr("taskc build good.task\n"), HasSubstr("the C++ compiler rejected")));
}

}  // namespace
}  // namespace compiler
