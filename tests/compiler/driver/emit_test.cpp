#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compiler/toolchain/file_io.h"
#include "tests/compiler/driver/taskc_process.h"

namespace compiler {
namespace {

using testing::HasSubstr;

TEST(Emit, PrintsTheCpp) {
  TaskcProcess taskc;
  taskc.Write("good.task", kGoodTask);
  Outcome outcome = taskc.Run("emit good.task");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out, testing::AllOf(HasSubstr("#include <taskc/plugin.h>"),
                                          HasSubstr("#line 2 \"good.task\"")));
  Outcome written = taskc.Run("emit good.task -o good.cpp");
  EXPECT_EQ(written.out, "");
  EXPECT_EQ(ReadWholeFile(taskc.path("good.cpp")), outcome.out);
}

TEST(Emit, PrintsWhichLinesALineHasBecome) {
  TaskcProcess taskc;
  taskc.Write("good.task", kGoodTask);
  Outcome outcome = taskc.Run("emit --map good.task");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out, testing::MatchesRegex("(good\\.task:[0-9]+ +[-0-9, ]+\n)+"));
}

TEST(Emit, WritesNothingForAWrongTask) {
  TaskcProcess taskc;
  taskc.Write("bad.task", "task bad\nmetric x = nothing\n");
  EXPECT_EQ(taskc.Run("emit bad.task -o bad.cpp").status, 1);
  EXPECT_FALSE(std::filesystem::exists(taskc.path("bad.cpp")));
}

}  // namespace
}  // namespace compiler
