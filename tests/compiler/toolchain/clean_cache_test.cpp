#include "compiler/toolchain/clean_cache.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include "base/seal/seal.h"
#include "compiler/toolchain/file_io.h"
#include "tests/compiler/temporary_folder.h"

namespace compiler {
namespace {

namespace fs = std::filesystem;
using testing::UnorderedElementsAre;

// Names as builds give them.
std::string Plugin(char digit) { return "task-" + std::string(32, digit) + ".so"; }
std::string Net(char digit) { return "net-" + std::string(32, digit); }
std::string Refused(char digit) { return "refused-task-" + std::string(32, digit); }
std::string Unfinished(char digit) { return "building-task-" + std::string(32, digit) + "-x7Qp2a"; }

class CleanCacheTest : public testing::Test {
 protected:
  // Of 100 bytes, last used this long ago.
  void AddFile(const std::string& name, std::chrono::minutes age) {
    WriteWholeFile(folder_.path() / name, seal::Seal(std::string(100 - seal::kSize, 'x')));
    Date(name, age);
  }
  void AddFolder(const std::string& name, std::chrono::minutes age) {
    fs::create_directory(folder_.path() / name);
    AddFile(name + "/plugin.cpp", age);
    Date(name, age);
  }
  void Date(const std::string& name, std::chrono::minutes age) {
    fs::last_write_time(folder_.path() / name, fs::file_time_type::clock::now() - age);
  }
  void Clean(uintmax_t limit) { CleanCache(folder_.path(), limit); }

  std::vector<std::string> Names() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path())) {
      names.push_back(entry.path().lexically_relative(folder_.path()));
    }
    std::ranges::sort(names);
    return names;
  }

  TemporaryFolder folder_;
};

TEST_F(CleanCacheTest, RemovesWhatKilledBuildsLeftBehind) {
  AddFolder(Unfinished('1'), std::chrono::hours(2));
  AddFolder(Unfinished('2'), std::chrono::minutes(2));
  AddFile(Unfinished('3'), std::chrono::hours(2));
  AddFile(Plugin('4'), std::chrono::hours(2));
  Clean(kLargestCache);
  EXPECT_THAT(Names(),
              UnorderedElementsAre(Unfinished('2'), Unfinished('2') + "/plugin.cpp", Plugin('4')));
}

TEST_F(CleanCacheTest, RemovesTheLeastRecentlyUsedFirst) {
  AddFile(Plugin('1'), std::chrono::hours(3));
  AddFile(Net('2'), std::chrono::hours(4));
  AddFolder(Refused('3'), std::chrono::hours(5));
  AddFile(Plugin('4'), std::chrono::hours(2));
  Clean(400);
  EXPECT_EQ(Names().size(), 5u);
  Clean(399);
  EXPECT_THAT(Names(), UnorderedElementsAre(Plugin('1'), Net('2'), Plugin('4')));
  NoteUse(folder_.path() / Net('2'));
  Clean(200);
  EXPECT_THAT(Names(), UnorderedElementsAre(Net('2'), Plugin('4')));
}

TEST_F(CleanCacheTest, KeepsWhatSomeoneMayBeAboutToCopy) {
  AddFile(Plugin('1'), std::chrono::minutes(0));
  Clean(0);
  EXPECT_THAT(Names(), UnorderedElementsAre(Plugin('1')));
}

// A folder that the user has named may be full of files of the user's own.
TEST_F(CleanCacheTest, LeavesAloneWhatOthersHavePutThere) {
  const std::chrono::hours old(24 * 365);
  AddFile("libfoo.so.1.2", old);
  AddFile("thesis.tex", old);
  AddFolder("building-site", old);
  AddFolder("building-blocks", old);
  AddFolder("photos", old);
  AddFolder(Plugin('1'), old);                                          // the name of a file
  AddFile(Refused('2'), old);                                           // the name of a folder
  WriteWholeFile(folder_.path() / Plugin('3'), std::string(100, 'x'));  // another's hash: no seal
  Date(Plugin('3'), old);
  fs::create_symlink(".", folder_.path() / "itself");
  fs::create_symlink(".", folder_.path() / Unfinished('4'));
  fs::create_symlink(".", folder_.path() / Refused('5'));
  fs::create_symlink("thesis.tex", folder_.path() / Plugin('6'));
  const std::vector<std::string> before = Names();
  Clean(kLargestCache);
  EXPECT_EQ(Names(), before);
  AddFile(Plugin('7'), old);
  Clean(100);  // others' files do not count
  EXPECT_TRUE(fs::exists(folder_.path() / Plugin('7')));
  Clean(0);
  EXPECT_EQ(Names(), before);
}

TEST_F(CleanCacheTest, MindsNoCacheThatIsNotThere) {
  CleanCache(folder_.path() / "absent", 0);
  NoteUse(folder_.path() / "absent.so");
}

}  // namespace
}  // namespace compiler
