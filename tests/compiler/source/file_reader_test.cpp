#include "compiler/source/file_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "compiler/source/diagnostic.h"

namespace compiler {
namespace {

TEST(FileReader, KeepsEveryByte) {
  const std::string path = testing::TempDir() + "taskc_source_file_test.task";
  const std::string text("a\r\n\0b\xff", 6);
  std::ofstream(path, std::ios::binary) << text;
  EXPECT_EQ(MustReadFromDisk(path), text);
  EXPECT_EQ(ReadFromDisk(path), text);
  std::filesystem::remove(path);
}

TEST(FileReader, NamesTheFileAndTheReason) {
  try {
    MustReadFromDisk("/nowhere/crawling.task");
    FAIL() << "read a file that does not exist";
  } catch (const CallError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("/nowhere/crawling.task"));
    EXPECT_THAT(error.what(), testing::HasSubstr("No such file"));
  }
}

TEST(FileReader, RefusesAFolder) {
  try {
    MustReadFromDisk(testing::TempDir());
    FAIL() << "read a folder";
  } catch (const CallError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("folder"));
  }
}

TEST(FileReader, HasNothingWhereThereIsNoFile) {
  EXPECT_EQ(ReadFromDisk("/nowhere/crawling.task"), std::nullopt);
  EXPECT_EQ(ReadFromDisk(testing::TempDir()), std::nullopt);
}

}  // namespace
}  // namespace compiler
