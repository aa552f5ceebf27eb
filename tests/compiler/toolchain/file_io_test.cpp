#include "compiler/toolchain/file_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "compiler/source/diagnostic.h"
#include "tests/compiler/temporary_folder.h"

namespace compiler {
namespace {

using testing::AllOf;
using testing::HasSubstr;

namespace fs = std::filesystem;

std::string ErrorOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const CallError& error) {
    return error.what();
  }
  return "no error";
}

TEST(FileIo, ReadsBackWhatItWrote) {
  TemporaryFolder folder;
  std::string bytes("a\0b\n", 4);
  WriteWholeFile(folder.path() / "file", bytes);
  EXPECT_EQ(ReadWholeFile(folder.path() / "file"), bytes);
  EXPECT_EQ(ReadWholeFile(folder.path() / "absent"), std::nullopt);
  EXPECT_EQ(ReadWholeFile(folder.path()), std::nullopt);
}

TEST(FileIo, ReplacesAFileWithoutTouchingTheOldOne) {
  TemporaryFolder folder;
  fs::path file = folder.path() / "file";
  WriteWholeFile(file, "old");
  fs::create_hard_link(file, folder.path() / "still-open");
  ReplaceFile(file, "new");
  EXPECT_EQ(ReadWholeFile(file), "new");
  EXPECT_EQ(ReadWholeFile(folder.path() / "still-open"), "old");
}

TEST(FileIo, GivesANewFileTheUsualPermissions) {
  TemporaryFolder folder;
  mode_t before = umask(022);
  ReplaceFile(folder.path() / "file", "new");
  umask(before);
  EXPECT_EQ(fs::status(folder.path() / "file").permissions(), static_cast<fs::perms>(0644));
}

TEST(FileIo, WritesDevicesAsTheyAre) {
  ReplaceFile("/dev/null", "gone");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(FileIo, NamesTheFileAndTheReason) {
  TemporaryFolder folder;
  EXPECT_THAT(ErrorOf([] { ReplaceFile("/dev/full", "x"); }),
              AllOf(HasSubstr("`/dev/full`"), HasSubstr("No space left on device")));
  EXPECT_THAT(ErrorOf([&] { ReplaceFile(folder.path() / "absent" / "file", "x"); }),
              AllOf(HasSubstr("absent/file`"), HasSubstr("No such file or directory")));
  EXPECT_THAT(ErrorOf([&] { ReplaceFile(folder.path(), "x"); }), HasSubstr("Is a directory"));
}

TEST(FileIo, LeavesNothingBehindAFailure) {
  TemporaryFolder folder;
  fs::create_directory(folder.path() / "target");
  ErrorOf([&] { ReplaceFile(folder.path() / "target", "x"); });
  auto entries = fs::directory_iterator(folder.path());
  EXPECT_EQ(std::distance(begin(entries), end(entries)), 1);
}

}  // namespace
}  // namespace compiler
