// The tasks in examples/tasks as a user meets them.
#include <gmock/gmock.h>

#include <string>

#include "runtime/training/run/run_database.h"
#include "tests/runtime/trainer/child_process.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace examples {
namespace {

using runtime::ProgramResult;
using runtime::RunProgram;
using testing::EndsWith;

class Programs : public testing::TestWithParam<std::string> {
 protected:
  static std::string File() { return SOURCE_DIR "/examples/tasks/" + GetParam() + ".task"; }
};

TEST_P(Programs, CheckItWithoutAWarning) {
  const ProgramResult result = RunProgram({TASKC, "check", File()});
  EXPECT_EQ(result.exit_status, 0);
  EXPECT_EQ(result.errors, "");
}

TEST_P(Programs, FindItsLayoutGood) {
  const ProgramResult result = RunProgram({TASKC, "fmt", "--check", File()});
  EXPECT_EQ(result.exit_status, 0) << result.output << result.errors;
}

TEST_P(Programs, WriteItsPage) {
  const ProgramResult result = RunProgram({TASKC, "doc", File()});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
}

TEST_P(Programs, RunItsTests) {
  const ProgramResult result = RunProgram({TASKC, "test", File()});
  EXPECT_EQ(result.exit_status, 0) << result.output << result.errors;
  EXPECT_THAT(result.output, EndsWith("all ok\n"));
}

TEST_P(Programs, TrainIt) {
  const runtime::TemporaryFolder folder;
  const std::string run = (folder.path() / "run").string();
  const ProgramResult result = RunProgram({TRAINER, "train", File(), "--profile", "fast-tree",
                                           "--episodes", "20", "--out", run, "--quiet"});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  const auto episodes = runtime::RunDatabase::OpenToRead(run).ReadEpisodes();
  EXPECT_EQ(episodes.size(), 20u);
  for (const runtime::EpisodeRecord& episode : episodes) EXPECT_EQ(episode.active.faults, 0);
}

INSTANTIATE_TEST_SUITE_P(Examples, Programs,
                         testing::Values("crawling_prone", "drive", "follow", "get_up", "guided",
                                         "hop", "leap", "scuttle", "swing_up", "trot", "march",
                                         "prance", "press_up", "kick", "climb", "push", "reach",
                                         "rise", "rise_lying", "stand", "step", "stride", "targets",
                                         "track", "track_speed", "velocity", "walk"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace examples
