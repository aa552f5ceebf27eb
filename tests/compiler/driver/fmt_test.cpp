#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compiler/toolchain/file_io.h"
#include "tests/compiler/driver/taskc_process.h"

namespace compiler {
namespace {

using testing::HasSubstr;

constexpr const char* kUntidy = "task  t\nmemory a:int=0\n";
constexpr const char* kTidy = "task t\nmemory a: int = 0\n";

TEST(Fmt, RewritesFilesInPlace) {
  TaskcProcess taskc;
  taskc.Write("a.task", kUntidy);
  taskc.Write("b.task", kTidy);
  const auto before = std::filesystem::last_write_time(taskc.path("b.task"));
  Outcome outcome = taskc.Run("fmt a.task b.task");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out + outcome.error, "");
  EXPECT_EQ(ReadWholeFile(taskc.path("a.task")), kTidy);
  EXPECT_EQ(std::filesystem::last_write_time(taskc.path("b.task")), before);
}

TEST(Fmt, LeavesLinksAndPermissions) {
  TaskcProcess taskc;
  taskc.Write("a.task", kUntidy);
  const auto permissions = std::filesystem::perms::owner_read | std::filesystem::perms::owner_write;
  std::filesystem::permissions(taskc.path("a.task"), permissions);
  std::filesystem::create_symlink("a.task", taskc.path("link.task"));
  EXPECT_EQ(taskc.Run("fmt link.task").status, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(taskc.path("link.task")));
  EXPECT_EQ(ReadWholeFile(taskc.path("a.task")), kTidy);
  EXPECT_EQ(std::filesystem::status(taskc.path("a.task")).permissions(), permissions);
}

TEST(Fmt, ListsWhatWouldChange) {
  TaskcProcess taskc;
  taskc.Write("a.task", kUntidy);
  taskc.Write("b.task", kTidy);
  Outcome outcome = taskc.Run("fmt --check a.task b.task");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out, "a.task\n");
  EXPECT_EQ(ReadWholeFile(taskc.path("a.task")), kUntidy);
  EXPECT_EQ(taskc.Run("fmt --check b.task").status, 0);
}

TEST(Fmt, FormatsItsInput) {
  TaskcProcess taskc;
  taskc.Write("a.task", kUntidy);
  EXPECT_EQ(taskc.Run("fmt - <a.task").out, kTidy);
  EXPECT_EQ(taskc.Run("fmt --check - <a.task").status, 1);
}

TEST(Fmt, DoesNotTouchWhatItCannotRead) {
  TaskcProcess taskc;
  taskc.Write("a.task", "task  t\nmemory a:=0\n");
  taskc.Write("b.task", kUntidy);
  Outcome outcome = taskc.Run("fmt a.task absent.task b.task");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.error, HasSubstr("a.task:2:9"));
  EXPECT_THAT(outcome.error, HasSubstr("`absent.task`"));
  EXPECT_EQ(ReadWholeFile(taskc.path("a.task")), "task  t\nmemory a:=0\n");
  EXPECT_EQ(ReadWholeFile(taskc.path("b.task")), kTidy);
}

}  // namespace
}  // namespace compiler
