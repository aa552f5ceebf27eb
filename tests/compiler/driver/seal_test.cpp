#include "base/seal/seal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compiler/toolchain/file_io.h"
#include "tests/compiler/driver/taskc_process.h"

namespace compiler {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;

constexpr const char* kSharedObject =
    "\x7f"
    "ELF and so on";

std::string In(const TaskcProcess& taskc, const std::string& file) {
  return ReadWholeFile(taskc.path(file)).value_or("");
}

TEST(SealVerb, SealsWhatHasNoSeal) {
  TaskcProcess taskc;
  taskc.Write("mine.so", kSharedObject);
  fs::permissions(taskc.path("mine.so"), static_cast<fs::perms>(0750));
  fs::create_symlink("mine.so", taskc.path("link.so"));
  EXPECT_EQ(taskc.Run("seal link.so").status, 0);
  EXPECT_TRUE(fs::is_symlink(taskc.path("link.so")));
  EXPECT_EQ(In(taskc, "mine.so"), seal::Seal(kSharedObject));
  EXPECT_EQ(fs::status(taskc.path("mine.so")).permissions(), static_cast<fs::perms>(0750));
  EXPECT_THAT(taskc.Run("seal mine.so").out, HasSubstr("already sealed"));
  EXPECT_EQ(In(taskc, "mine.so"), seal::Seal(kSharedObject));
}

TEST(SealVerb, SealsNothingElse) {
  TaskcProcess taskc;
  std::string changed = seal::Seal(kSharedObject);
  changed[5] ^= 1;
  taskc.Write("changed.so", changed);
  taskc.Write("text.so", "task crawling for humanoid\n");
  taskc.Write("mine.so", kSharedObject);
  const Outcome outcome = taskc.Run("seal changed.so text.so absent.so mine.so");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.error, HasSubstr("`changed.so` has changed since it was sealed"));
  EXPECT_THAT(outcome.error, HasSubstr("`text.so` is not a shared object"));
  EXPECT_THAT(outcome.error, HasSubstr("cannot read `absent.so`: No such file"));
  EXPECT_EQ(In(taskc, "changed.so"), changed);
  EXPECT_EQ(In(taskc, "text.so"), "task crawling for humanoid\n");
  EXPECT_EQ(In(taskc, "mine.so"), seal::Seal(kSharedObject));  // none keeps another from its turn
}

}  // namespace
}  // namespace compiler
