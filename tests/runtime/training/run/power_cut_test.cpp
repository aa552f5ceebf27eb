// What the disk has been told when a run's folder names a file, and what a kill leaves at each of
// these moments.
#include <dlfcn.h>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <stdio.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "runtime/training/run/run_database.h"
#include "runtime/training/run/run_files.h"
#include "tests/runtime/training/run/error_of.h"
#include "tests/runtime/training/run/sample_run.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace {

// Called before each of the system's functions below.
std::function<void(const std::string& call)> before_call;

void Tell(const std::string& call) {
  if (before_call) before_call(call);
}

std::string NameOf(int descriptor) {
  std::error_code error;
  const auto file =
      std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor), error);
  return file.filename().string();
}

template <class Function>
Function* Next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

int fsync(int descriptor) {
  Tell("fsync " + NameOf(descriptor));
  return Next<int(int)>("fsync")(descriptor);
}

int fdatasync(int descriptor) {
  Tell("fsync " + NameOf(descriptor));
  return Next<int(int)>("fdatasync")(descriptor);
}

int rename(const char* from, const char* to) noexcept {
  Tell("rename " + std::filesystem::path(to).filename().string());
  return Next<int(const char*, const char*)>("rename")(from, to);
}

ssize_t pwrite64(int descriptor, const void* bytes, size_t count, off64_t offset) {
  Tell("write " + NameOf(descriptor));
  return Next<ssize_t(int, const void*, size_t, off64_t)>("pwrite64")(descriptor, bytes, count,
                                                                      offset);
}

}  // extern "C"

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::StartsWith;

class PowerCutTest : public testing::Test {
 protected:
  ~PowerCutTest() override { before_call = nullptr; }

  std::filesystem::path run() const { return folder_.path() / "run"; }
  std::filesystem::path plugin() const {
    std::ofstream(folder_.path() / "a.so") << "abc";
    return folder_.path() / "a.so";
  }
  void MakeRun() const {
    RunDatabase::CheckIsFree(run());
    RunRecord record = SampleRun();
    record.tasks.front().plugin = KeepPlugin(plugin(), run());
    RunDatabase::Create(run(), record).SetState(RunState::kInterrupted);
  }

  TemporaryFolder folder_;
};

TEST_F(PowerCutTest, APluginIsOnTheDiskBeforeItHasItsName) {
  std::vector<std::string> calls;
  before_call = [&](const std::string& call) { calls.push_back(call); };
  const std::string name = KeepPlugin(plugin(), run());
  EXPECT_THAT(calls, ElementsAre(testing::AllOf(StartsWith("fsync " + name), EndsWith(".part")),
                                 "rename " + name, "fsync run"));
  calls.clear();
  KeepPlugin(plugin(), run());  // is there: only its name may not be on the disk yet
  EXPECT_THAT(calls, ElementsAre("fsync run"));
}

TEST_F(PowerCutTest, ADatabaseIsOnTheDiskBeforeItHasItsName) {
  std::vector<std::string> calls;
  before_call = [&](const std::string& call) {
    if (!call.starts_with("write ")) calls.push_back(call);
  };
  RunDatabase::Create(run(), SampleRun());
  const auto named = std::ranges::find(calls, "rename run.db");
  ASSERT_NE(named, calls.end());
  EXPECT_NE(std::find(calls.begin(), named, "fsync run.db.part"), named);
  EXPECT_EQ(*(named + 1), "fsync run");
}

// At each call that changes what the folder holds: a run is there as a whole, or none is and it can
// be made.
TEST_F(PowerCutTest, ARunThatIsKilledWhileItIsMadeIsWholeOrNone) {
  int whole = 0;
  int none = 0;
  for (int last_call = 1;; ++last_call) {
    std::filesystem::remove_all(run());
    const pid_t child = fork();
    if (child == 0) {
      before_call = [calls = 0, last_call](const std::string&) mutable {
        if (++calls == last_call) _exit(1);
      };
      MakeRun();
      _exit(0);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    if (status == 0) break;  // it was done before
    if (RunDatabase::Exists(run())) {
      ++whole;
      const RunRecord record = RunDatabase::OpenToRead(run()).ReadRun();
      EXPECT_EQ(record.agent, SampleRun().agent);
      EXPECT_EQ(ReadText(FindKeptPlugin(run(), record.tasks.front().plugin)), "abc");
      EXPECT_EQ(ErrorOf([&] { RunDatabase::Open(run()); }), "");
    } else {
      ++none;
      EXPECT_EQ(ErrorOf([&] { MakeRun(); }), "");
    }
  }
  EXPECT_GT(whole, 0);
  EXPECT_GT(none, 10);
}

}  // namespace
}  // namespace runtime
