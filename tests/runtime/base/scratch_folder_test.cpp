#include "runtime/base/scratch_folder.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "tests/scoped_environment.h"

namespace runtime {
namespace {

namespace fs = std::filesystem;

class ScratchFolderTest : public testing::Test {
 protected:
  ScratchFolderTest() : temporary_("TMPDIR", folder_.string()) {}
  ~ScratchFolderTest() override { fs::remove_all(folder_); }

  static fs::path NewFolder() {
    std::string name = testing::TempDir() + "scratch_folder_test_XXXXXX";
    return mkdtemp(name.data());
  }

  std::vector<std::string> Names() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_))
      names.push_back(entry.path().filename());
    return names;
  }

  // Of a process that has one, with a file in it, when it is killed.
  void LeaveBehind() const {
    int ready[2];
    ASSERT_EQ(pipe(ready), 0);
    const pid_t process = fork();
    if (process == 0) {
      const ScratchFolder scratch;
      std::ofstream(scratch.path() / "task.so") << "x";
      [[maybe_unused]] const ssize_t ignored = write(ready[1], "x", 1);
      pause();
    }
    char byte;
    ASSERT_EQ(read(ready[0], &byte, 1), 1);
    close(ready[0]);
    close(ready[1]);
    kill(process, SIGKILL);
    waitpid(process, nullptr, 0);
  }

  const fs::path folder_ = NewFolder();
  const ScopedEnvironment temporary_;
};

TEST_F(ScratchFolderTest, IsGoneWithItsOwner) {
  {
    const ScratchFolder scratch;
    std::ofstream(scratch.path() / "file") << "x";
    EXPECT_TRUE(fs::is_directory(scratch.path()));
  }
  EXPECT_TRUE(Names().empty());
}

TEST_F(ScratchFolderTest, RemovesThoseOfKilledProcesses) {
  LeaveBehind();
  LeaveBehind();  // which removes the first
  EXPECT_EQ(Names().size(), 1u);
  const ScratchFolder scratch;
  EXPECT_THAT(Names(), testing::ElementsAre(scratch.path().filename()));
}

TEST_F(ScratchFolderTest, LeavesThoseInUse) {
  const ScratchFolder first;
  const ScratchFolder second;
  EXPECT_EQ(Names().size(), 2u);
  EXPECT_TRUE(fs::is_directory(first.path()));
}

TEST_F(ScratchFolderTest, LeavesWhatIsNotOurs) {
  for (const char* name : {"trainer-abc123", "taskc-trainer-photos1", "taskc-trainer-a.b123",
                           "taskc-trainer-", "my-taskc-trainer-abc123"}) {
    fs::create_directory(folder_ / name);
    fs::permissions(folder_ / name, fs::perms::owner_all);
  }
  fs::create_directory(folder_ / "taskc-trainer-shared");  // others may look into it
  fs::permissions(folder_ / "taskc-trainer-shared", static_cast<fs::perms>(0755));
  std::ofstream(folder_ / "taskc-trainer-file01") << "x";
  fs::create_directory(folder_ / "mine");
  fs::permissions(folder_ / "mine", fs::perms::owner_all);
  std::ofstream(folder_ / "mine" / "file") << "x";
  fs::create_symlink("mine", folder_ / "taskc-trainer-link01");
  const std::vector<std::string> before = Names();
  { const ScratchFolder scratch; }
  EXPECT_THAT(Names(), testing::UnorderedElementsAreArray(before));
  EXPECT_TRUE(fs::exists(folder_ / "mine" / "file"));
}

}  // namespace
}  // namespace runtime
