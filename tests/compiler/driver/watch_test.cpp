#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "compiler/toolchain/file_io.h"
#include "tests/compiler/driver/taskc_process.h"

namespace compiler {
namespace {

constexpr const char* kBrokenTask = "task good\non end_of_action {\n  reward a = nothing\n}\n";

// `taskc watch good.task`, running beside the test; what it prints goes to the file `log`.
class Watching {
 public:
  explicit Watching(const TaskcProcess& taskc) : taskc_(taskc), child_(fork()) {
    if (child_ != 0) return;
    const int log = open(taskc.path("log").c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
    dup2(log, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
    if (chdir(taskc.path("").c_str()) != 0) _exit(127);
    setenv("TASKC_CACHE", taskc.path("cache").c_str(), 1);
    execl(TASKC, TASKC, "watch", "good.task", nullptr);
    _exit(127);
  }
  ~Watching() {
    if (child_ > 0) Interrupt();
  }

  // Waits until `text` has been printed `times` times.
  bool Prints(const std::string& text, int times) const {
    for (int i = 0; i < 600; ++i) {
      const std::string log = ReadWholeFile(taskc_.path("log")).value_or("");
      int count = 0;
      for (size_t at = 0; (at = log.find(text, at)) != std::string::npos; ++at) ++count;
      if (count >= times) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return false;
  }

  int Interrupt() {
    kill(child_, SIGINT);
    int status = 0;
    waitpid(std::exchange(child_, -1), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  const TaskcProcess& taskc_;
  pid_t child_;
};

TEST(Watch, BuildsAgainWhenAFileIsSaved) {
  TaskcProcess taskc;
  taskc.Write("good.task", kGoodTask);
  Watching watching(taskc);
  ASSERT_TRUE(watching.Prints(".so\n", 1));
  taskc.Write("good.task", kBrokenTask);
  ASSERT_TRUE(watching.Prints("E0201", 1));
  ASSERT_TRUE(watching.Prints("1 error", 1));
  taskc.Write("good.task", kGoodTask);
  ASSERT_TRUE(watching.Prints(".so\n", 2));
  EXPECT_EQ(watching.Interrupt(), 0);
  EXPECT_THAT(ReadWholeFile(taskc.path("log")).value(), testing::ContainsRegex("-- ..:..:..\n"));
}

// As many editors do.
TEST(Watch, SeesAFileThatTakesTheOldOnesPlace) {
  TaskcProcess taskc;
  taskc.Write("good.task", kGoodTask);
  Watching watching(taskc);
  ASSERT_TRUE(watching.Prints(".so\n", 1));
  ReplaceFile(taskc.path("good.task"), kBrokenTask);
  ASSERT_TRUE(watching.Prints("E0201", 1));
  ReplaceFile(taskc.path("good.task"), kGoodTask);
  ASSERT_TRUE(watching.Prints(".so\n", 2));
}

TEST(Watch, WaitsForAFileThatIsNotThereYet) {
  TaskcProcess taskc;
  Watching watching(taskc);
  ASSERT_TRUE(watching.Prints("No such file", 1));
  taskc.Write("good.task", kGoodTask);
  ASSERT_TRUE(watching.Prints(".so\n", 1));
}

TEST(Watch, SeesTheRobotChange) {
  TaskcProcess taskc;
  std::string robot = ReadWholeFile(SOURCE_DIR "/plugins/humanoid/robot.toml").value();
  taskc.Write("humanoid/robot.toml", robot);
  taskc.Write("good.task", kGoodTask);
  Watching watching(taskc);
  ASSERT_TRUE(watching.Prints(".so\n", 1));
  taskc.Write("humanoid/robot.toml", "name = \n");
  ASSERT_TRUE(watching.Prints("robot.toml", 1));
}

}  // namespace
}  // namespace compiler
