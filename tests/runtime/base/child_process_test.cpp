#include "runtime/base/child_process.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <thread>

namespace runtime {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

// Zombies count as gone.
bool IsRunning(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string number, name, state;
  return file >> number >> name >> state && state != "Z" && state != "X";
}

bool Ends(pid_t process) {
  for (int tries = 0; tries < 500 && IsRunning(process); ++tries) {
    std::this_thread::sleep_for(10ms);
  }
  return !IsRunning(process);
}

class ChildProcessTest : public testing::Test {
 protected:
  ChildProcessTest() {
    std::string name = testing::TempDir() + "child_process_test_XXXXXX";
    folder_ = mkdtemp(name.data());
  }
  ~ChildProcessTest() override { std::filesystem::remove_all(folder_); }

  // A shell that starts a program which would run for very long, and waits for it. The program's
  // number goes to a file.
  std::vector<std::string> LongCall() const {
    return {
        "sh", "-c",
        "sleep 1000 & echo $! >" + part() + "; mv " + part() + " " + file() + "; echo begun; wait"};
  }
  pid_t WaitForLongProgram() const {
    pid_t process = 0;
    for (int tries = 0; tries < 1000 && !(std::ifstream(file()) >> process); ++tries) {
      std::this_thread::sleep_for(10ms);
    }
    return process;
  }

  std::string file() const { return folder_ + "/number"; }
  std::string part() const { return folder_ + "/part"; }

 private:
  std::string folder_;
};

TEST_F(ChildProcessTest, CapturesWhatIsWanted) {
  const std::vector<std::string> words = {"sh", "-c", "echo out; echo error >&2; exit 3"};
  EXPECT_EQ(RunChild(words, Captured::kOutputOnly).captured, "out\n");
  EXPECT_EQ(RunChild(words, Captured::kMessages).captured, "out\nerror\n");
  EXPECT_FALSE(RunChild(words, Captured::kMessages).is_success);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  EXPECT_EQ(RunChild(words, Captured::kOutput).captured, "out\n");
  EXPECT_EQ(RunChild(words, Captured::kNothing).captured, "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "error\nout\nerror\n");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  const ChildResult large = RunChild({"sh", "-c", "yes | head -c 1000000"}, Captured::kOutput);
  EXPECT_EQ(large.captured.size(), 1'000'000u);
  EXPECT_TRUE(large.is_success);
}

TEST_F(ChildProcessTest, SaysThatThereIsNoSuchProgram) {
  EXPECT_EQ(RunChild({"/nowhere/program"}, Captured::kNothing).error,
            std::errc::no_such_file_or_directory);
}

TEST_F(ChildProcessTest, KillsWithAllItsChildrenWhatTakesTooLong) {
  const auto start = Clock::now();
  const ChildResult result = RunChild(LongCall(), Captured::kOutput, {.patience = 1s});
  EXPECT_LT(Clock::now() - start, 60s);
  EXPECT_TRUE(result.was_too_slow);
  EXPECT_FALSE(result.is_success);
  EXPECT_EQ(result.captured, "begun\n");
  EXPECT_TRUE(Ends(WaitForLongProgram()));
}

TEST_F(ChildProcessTest, CanBeStopped) {
  std::stop_source stop;
  pid_t program = 0;
  std::thread stopper([&] {
    program = WaitForLongProgram();
    stop.request_stop();
  });
  const ChildResult result = RunChild(LongCall(), Captured::kOutput, {.stop = stop.get_token()});
  stopper.join();
  EXPECT_FALSE(result.was_too_slow);
  EXPECT_FALSE(result.is_success);
  EXPECT_TRUE(Ends(program));
  // Before it has begun.
  EXPECT_FALSE(
      RunChild({"sleep", "1000"}, Captured::kOutput, {.stop = stop.get_token()}).is_success);
}

// Such a program has the pipe as well.
TEST_F(ChildProcessTest, WaitsForNothingThatTheChildHasLeftBehind) {
  const auto start = Clock::now();
  const ChildResult result =
      RunChild({"sh", "-c", "echo first; setsid sleep 30 & sleep 0.2; exit 0"}, Captured::kOutput);
  EXPECT_LT(Clock::now() - start, 25s);
  EXPECT_TRUE(result.is_success);
  EXPECT_EQ(result.captured, "first\n");
}

TEST_F(ChildProcessTest, ChildDiesWithItsParent) {
  const pid_t parent = fork();
  if (parent == 0) {
    RunChild(
        {"sh", "-c", "echo $$ >" + part() + "; mv " + part() + " " + file() + "; exec sleep 1000"},
        Captured::kNothing);
    _exit(0);
  }
  const pid_t program = WaitForLongProgram();
  EXPECT_TRUE(IsRunning(program));
  kill(parent, SIGKILL);
  waitpid(parent, nullptr, 0);
  EXPECT_TRUE(Ends(program));
}

}  // namespace
}  // namespace runtime
