// What a process in the sandbox can ask of the one outside. Each test is a process of its own, as
// programs are started outside from then on.
#include "runtime/base/program_starter.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <cstdlib>
#include <fstream>

#include "runtime/base/child_process.h"
#include "runtime/base/user_error.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {
namespace {

bool MayStart(const std::vector<std::string>& words) {
  return words[0] == "/bin/echo" || words[0] == "/bin/sleep" || words[0] == "/no/such/program";
}

// Ends this process, with success if `holds` does.
template <class Condition>
[[noreturn]] void Check(const Condition& holds) {
  StartProgramsOutside(MayStart);
  std::_Exit(AreProgramsStartedOutside() && holds() ? 0 : 1);
}

#define EXPECT_OUTSIDE(...) EXPECT_EXIT(Check([&] __VA_ARGS__), testing::ExitedWithCode(0), "")

TEST(ProgramStarter, RunsWhatItMay) {
  EXPECT_OUTSIDE({
    const ChildResult result = RunChild({"/bin/echo", "hello", "", "you"}, Captured::kOutput);
    return !result.error && result.is_success && result.captured == "hello  you\n";
  });
}

TEST(ProgramStarter, RefusesEverythingElse) {
  EXPECT_OUTSIDE({
    const ChildResult result = RunChild({"/bin/true"}, Captured::kOutput);
    return result.error.value() == EPERM && !result.is_success;
  });
}

TEST(ProgramStarter, SaysWhyAProgramCannotBeStarted) {
  EXPECT_OUTSIDE(
      { return RunChild({"/no/such/program"}, Captured::kOutput).error.value() == ENOENT; });
}

TEST(ProgramStarter, KillsWhatTakesTooLong) {
  EXPECT_OUTSIDE({
    const auto begin = std::chrono::steady_clock::now();
    const ChildResult result = RunChild({"/bin/sleep", "100"}, Captured::kOutput,
                                        {.patience = std::chrono::milliseconds(50)});
    const auto took = std::chrono::steady_clock::now() - begin;
    return result.was_too_slow && !result.is_success && took < std::chrono::seconds(50);
  });
}

TEST(ProgramStarter, HandsInPluginsOnly) {
  const TemporaryFolder folder;
  const std::filesystem::path copy = folder.path() / "copy";
  EXPECT_OUTSIDE({
    CopyPluginFromOutside("/proc/self/exe", copy);
    return std::filesystem::file_size(copy) > 1000;
  });
  EXPECT_OUTSIDE({
    CopyPluginFromOutside("/etc/passwd", copy);
    return std::filesystem::file_size(copy) == 0;
  });
}

TEST(ProgramStarter, HandsInTablesOnlyByTheirOwnName) {
  const TemporaryFolder folder;
  // Through a link, so that whoever opens it here must not be able to.
  std::ofstream(folder.path() / "secret") << "secret";
  std::filesystem::create_symlink(folder.path() / "secret", folder.path() / "link.csv");
  std::ofstream(folder.path() / "table.csv") << "1,2";
  const auto outside = [&](const char* name) {
    const OutsideProgram errand({"read-table", (folder.path() / name).string()}, {0, 1, 2});
    return errand.WaitForEnd().error;
  };
  EXPECT_OUTSIDE({ return outside("table.csv") == 0; });
  EXPECT_OUTSIDE({ return outside("link.csv") == EACCES; });
  EXPECT_OUTSIDE({ return outside("none.csv") == ENOENT; });
}

}  // namespace
}  // namespace runtime
