#include "compiler/build/clean_cache.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

#include "compiler/build/file_io.h"
#include "tests/compiler/temporary_folder.h"

namespace compiler {
namespace {

namespace fs = std::filesystem;
using testing::UnorderedElementsAre;

class CleanCacheTest : public testing::Test {
 protected:
  // Of 100 bytes, last used this long ago.
  void AddFile(const std::string& name, std::chrono::minutes age) {
    WriteWholeFile(folder_.path() / name, std::string(100, 'x'));
    Date(name, age);
  }
  void AddFolder(const std::string& name, std::chrono::minutes age) {
    fs::create_directory(folder_.path() / name);
    AddFile(name + "/plugin.cpp", age);
    Date(name, age);
  }
  void Clean(uintmax_t limit) { CleanCache(folder_.path(), limit); }

  std::vector<std::string> Names() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_.path())) {
      names.push_back(entry.path().filename());
    }
    return names;
  }

  TemporaryFolder folder_;

 private:
  void Date(const std::string& name, std::chrono::minutes age) {
    fs::last_write_time(folder_.path() / name, fs::file_time_type::clock::now() - age);
  }
};

TEST_F(CleanCacheTest, RemovesWhatKilledBuildsLeftBehind) {
  AddFolder("building-killed", std::chrono::hours(2));
  AddFolder("building-running", std::chrono::minutes(2));
  AddFile("task-01.so.Xy12Za", std::chrono::hours(2));
  AddFile("task-01.so.Xy12Zb", std::chrono::minutes(2));
  AddFile("task-01.so", std::chrono::hours(2));
  Clean(kLargestCache);
  EXPECT_THAT(Names(), UnorderedElementsAre("building-running", "task-01.so.Xy12Zb", "task-01.so"));
}

TEST_F(CleanCacheTest, RemovesTheLeastRecentlyUsedFirst) {
  AddFile("old.so", std::chrono::hours(3));
  AddFile("older.so", std::chrono::hours(4));
  AddFolder("refused-task-01", std::chrono::hours(5));
  AddFile("new.so", std::chrono::hours(2));
  Clean(400);
  EXPECT_EQ(Names().size(), 4u);
  Clean(399);
  EXPECT_THAT(Names(), UnorderedElementsAre("old.so", "older.so", "new.so"));
  NoteUse(folder_.path() / "older.so");
  Clean(200);
  EXPECT_THAT(Names(), UnorderedElementsAre("older.so", "new.so"));
}

TEST_F(CleanCacheTest, KeepsWhatSomeoneMayBeAboutToCopy) {
  AddFile("fresh.so", std::chrono::minutes(0));
  Clean(0);
  EXPECT_THAT(Names(), UnorderedElementsAre("fresh.so"));
}

TEST_F(CleanCacheTest, MindsNoCacheThatIsNotThere) {
  CleanCache(folder_.path() / "absent", 0);
  NoteUse(folder_.path() / "absent.so");
}

}  // namespace
}  // namespace compiler
