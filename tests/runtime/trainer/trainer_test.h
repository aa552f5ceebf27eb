// What the tests of the program `trainer` share: a task with short episodes, and a look at its
// runs.
#pragma once

#include <gmock/gmock.h>

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/training/run/run_database.h"
#include "tests/runtime/trainer/child_process.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {

class TrainerTest : public testing::Test {
 protected:
  // TRAINER and TASKS come from the build.
  static std::string TaskFile(const std::string& name) {
    return std::string(TASKS) + "/" + name + ".task";
  }
  static ProgramResult Trainer(std::vector<std::string> words) {
    words.insert(words.begin(), TRAINER);
    return RunProgram(std::move(words));
  }

  std::filesystem::path folder() const { return parent_.path(); }
  std::string RunFolder(const std::string& name) const { return (parent_.path() / name).string(); }

  // The words for a training of the task `leaning` in the run folder `name`.
  std::vector<std::string> Training(const std::string& name, int episodes,
                                    std::vector<std::string> more = {}) const {
    std::vector<std::string> words = {"train", TaskFile("leaning"), "--profile",
                                      "fast",  "--episodes",        std::to_string(episodes),
                                      "--out", RunFolder(name)};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  // Trains and expects success.
  void Train(const std::string& name, int episodes, std::vector<std::string> more = {}) const {
    const ProgramResult result = Trainer(Training(name, episodes, std::move(more)));
    ASSERT_EQ(result.exit_status, 0) << result.errors;
  }

  // Returns when the process that trains the run `name` is within an episode. A first Ctrl-C that
  // comes earlier ends the run at once, and then there is none to stop by a second.
  void WaitForAStep(const std::string& name) const;

  // Everything about a run's episodes that must not depend on when and how often it was
  // interrupted.
  struct Trace {
    std::vector<std::string> episodes;  // all but the wall time, in a form that shows every bit
    std::vector<std::string> recordings;
  };
  Trace TraceOf(const std::string& name) const;

  static void ExpectEqual(const Trace& a, const Trace& b) {
    EXPECT_EQ(a.episodes, b.episodes);
    EXPECT_TRUE(a.recordings == b.recordings) << "recordings differ";
  }

 private:
  TemporaryFolder parent_;
};

}  // namespace runtime
