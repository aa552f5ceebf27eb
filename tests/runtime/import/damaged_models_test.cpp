// Models that are nearly right: each becomes a robot, or there is an error that names the file,
// soon and in bounded memory.
//
//     TASKC_IMPORT_SECONDS=3600 build/tests/runtime_import_test --gtest_filter='DamagedModels.*'
//
// tries others for an hour; without it the test is brief, and its models are the same every time.
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "fuzz/mutator.h"
#include "plugins/robot/robot_description.h"
#include "runtime/base/user_error.h"
#include "runtime/import/import_robot.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {
namespace {

namespace fs = std::filesystem;

constexpr long kModels = 150;
constexpr rlim_t kMemory = 3'000'000'000;  // bytes: 2 GB for MuJoCo's attempt, in its own process

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;  // slower, and with maps of its own as large as all memory
#else
constexpr bool kIsSanitized = false;
#endif
constexpr time_t kMostSeconds = kIsSanitized ? 200 : 20;  // of CPU time: the robot is held for one

std::vector<std::string> Models() {
  std::vector<std::string> texts;
  for (const char* name : {"crawler.urdf", "walker.xml", "arm.xml"}) {
    std::ifstream file(fs::path(MODELS) / name, std::ios::binary);
    texts.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return texts;
}

std::vector<std::string> Words() {
  return {"0",
          "-1",
          "nan",
          "inf",
          "1e308",
          "1e-300",
          "1000000",
          "90 -90",
          "free",
          "ball",
          "slide",
          "world",
          "mesh",
          "hfield",
          "floating",
          "\"\"",
          "name=\"if\"",
          "<link/>",
          "<body>",
          "</body>",
          "<joint/>",
          "<freejoint/>",
          "<include file=\"model.xml\"/>",
          "<xacro:macro/>",
          "count=\"9 9 9\"",
          "gear=\"0\"",
          "size=\"1e9\"",
          "range=\"1 1\"",
          "euler=\"nan 0 0\"",
          "&amp;",
          "&#x0;",
          "<!--",
          "-->",
          "<![CDATA[",
          "\xff",
          std::string(1, '\0')};
}

// Memory that the child process shares with us, so that we know its last model.
struct Progress {
  long models;
  long robots;  // how many of them became one
  size_t size;
  char text[1 << 16];
  char error[1024];
};

Progress& SharedProgress() {
  void* memory =
      mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  return *static_cast<Progress*>(memory);
}

void Limit() {
  const itimerval timer{{0, 0}, {kMostSeconds, 0}};
  setitimer(ITIMER_VIRTUAL, &timer, nullptr);  // a model that takes longer ends the process
  const rlimit memory{kMemory, kMemory};
  if (!kIsSanitized) setrlimit(RLIMIT_AS, &memory);
}

// Whether it became a robot. Ends the process where an error does not name the file.
bool Import(const std::string& text, const fs::path& folder, Progress& progress) {
  const fs::path file = folder / "model.xml";
  std::ofstream(file, std::ios::binary) << text;
  fs::remove_all(folder / "robots");
  try {
    robot::ReadRobot(ImportRobot({.file = file, .folder = folder / "robots"}).file);
    return true;
  } catch (const UserError& error) {
    std::strncpy(progress.error, error.what(), sizeof progress.error - 1);
    if (!std::string_view(error.what()).starts_with(folder.string())) std::abort();
    progress.error[0] = '\0';
  }
  return false;
}

// A process of its own for so many: MuJoCo keeps some memory of each model that it refuses.
[[noreturn]] void ImportAll(const fs::path& folder, Progress& progress, uint32_t seed) {
  fuzz::Mutator mutator(Models(), Words(), seed);
  for (long i = 0; i < kModels; ++i, ++progress.models) {
    const std::string text = mutator.Next();
    progress.size = std::min(text.size(), sizeof progress.text);
    std::memcpy(progress.text, text.data(), progress.size);
    Limit();
    if (Import(text, folder, progress)) ++progress.robots;
  }
  _exit(0);
}

// Whether all went well.
bool ImportInChild(const fs::path& folder, Progress& progress, uint32_t seed) {
  const pid_t child = fork();
  if (child == 0) ImportAll(folder, progress, seed);
  int status = -1;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0) << (WIFSIGNALED(status) ? strsignal(WTERMSIG(status)) : "") << " "
                       << progress.error << "\n"
                       << std::string(progress.text, progress.size);
  return status == 0;
}

TEST(DamagedModels, BecomeRobotsOrErrorsThatNameTheFile) {
  const TemporaryFolder folder;
  Progress& progress = SharedProgress();
  const char* seconds = std::getenv("TASKC_IMPORT_SECONDS");
  const auto end = std::chrono::steady_clock::now() +
                   std::chrono::seconds(seconds == nullptr ? 0 : std::atol(seconds));
  uint32_t seed = seconds == nullptr ? 1 : std::random_device()();
  while (ImportInChild(folder.path(), progress, seed++) && std::chrono::steady_clock::now() < end) {
  }
  EXPECT_GT(progress.robots, progress.models / 20);  // they are nearly right
  EXPECT_LT(progress.robots, progress.models);
  std::printf("%ld models, of which %ld became robots\n", progress.models, progress.robots);
  munmap(&progress, sizeof progress);
}

// Nothing is left out of what is tried: they are right.
TEST(DamagedModels, BeginWithSoundOnes) {
  const TemporaryFolder folder;
  Progress& progress = SharedProgress();
  for (const std::string& text : Models()) EXPECT_TRUE(Import(text, folder.path(), progress));
  munmap(&progress, sizeof progress);
}

}  // namespace
}  // namespace runtime
