#include <csignal>
#include <fstream>
#include <string>

#include "base/file/read.h"
#include "tests/runtime/trainer/trainer_test.h"
#include "tests/scoped_environment.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class FailureTest : public TrainerTest {};

// The text with the rest of the line behind `key = ` replaced.
std::string WithValue(std::string text, const std::string& key, const std::string& value) {
  const size_t start = text.find("\n" + key + " = ") + 1;
  text.replace(start, text.find('\n', start) - start, key + " = " + value);
  return text;
}

TEST_F(FailureTest, WarnsOfRewardsThatAreNotFinite) {
  const ProgramResult result = Trainer({"train", TaskFile("faulty"), "--profile", "fast",
                                        "--episodes", "2", "--quiet", "--out", RunFolder("run")});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_THAT(result.errors,
              HasSubstr("warning: episode 2: not finite, or beyond 1e+30, and so not paid: "
                        "`quotient` (" +
                        TaskFile("faulty") + ":8) 1x, first at 0.025 s"));
  // Which part of it, said once; and what the robot did up to then can be seen.
  EXPECT_THAT(result.errors,
              HasSubstr("warning: episode 1: not finite, or beyond 1e+30, and so not paid: "
                        "`quotient` (" +
                        TaskFile("faulty") + ":8) 1x, first at 0.025 s: `1 / (steps - 5)` (" +
                        TaskFile("faulty") + ":8:39) is infinity, where `(steps - 5)` is 0\n"));
  EXPECT_TRUE(RunDatabase::OpenToRead(RunFolder("run")).ReadRecording(1));
  for (const EpisodeRecord& episode : RunDatabase::OpenToRead(RunFolder("run")).ReadEpisodes()) {
    EXPECT_EQ(episode.active.faults, 1);
    EXPECT_EQ(episode.active.episode_return, 0);
  }
}

// The learner goes on as if those rewards had never been.
TEST_F(FailureTest, ASumOfRewardsThatOverflowsCostsTheLearnerNothing) {
  const auto train = [&](const std::string& name, const std::string& is_sound) {
    const ProgramResult result =
        Trainer({"train", TaskFile("overflowing"), "--profile", "fast", "--episodes", "5",
                 "--quiet", "--set", "task.is_sound=" + is_sound, "--out", RunFolder(name)});
    EXPECT_EQ(result.exit_status, 0) << result.errors;
    return result.errors;
  };
  EXPECT_EQ(train("sound", "true"), "");
  EXPECT_THAT(train("run", "false"),
              AllOf(HasSubstr("warning: episode 2: not finite, or beyond 1e+30, and so not paid: "
                              "`huge` (" +
                              TaskFile("overflowing") + ":14) 47x, first at 0.005 s"),
                    Not(HasSubstr("episode 3"))));
  const auto episodes = RunDatabase::OpenToRead(RunFolder("run")).ReadEpisodes();
  const auto sound = RunDatabase::OpenToRead(RunFolder("sound")).ReadEpisodes();
  ASSERT_EQ(episodes.size(), 5u);
  EXPECT_GT(episodes[1].active.faults, 0);
  for (size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(episodes[i].active.episode_return, sound[i].active.episode_return);
    EXPECT_EQ(episodes[i].active.terms, sound[i].active.terms);
  }
}

TEST_F(FailureTest, WarnsOfALearnerThatDiverges) {
  std::vector<std::string> words = Training("run", 20, {"--set", "learner.learning_rate=1e20"});
  words.insert(words.end(), {"--set", "learner.learning_rate_min=1e20", "--quiet"});
  const ProgramResult result = Trainer(words);
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_THAT(result.errors, AllOf(HasSubstr("actions were not learned from"),
                                   HasSubstr("lower `learner.learning_rate`")));
  EXPECT_GT(RunDatabase::OpenToRead(RunFolder("run")).ReadEpisodes().back().active.faults, 0);
}

TEST_F(FailureTest, GoesOnAfterASimulationThatDiverged) {
  const std::filesystem::path robot = folder() / "robots" / "humanoid";
  std::filesystem::create_directories(robot);
  std::filesystem::copy_file(ROBOTS "/humanoid/agent.toml", robot / "agent.toml");
  std::string description = file::Read(ROBOTS "/humanoid/robot.toml").bytes;
  description = WithValue(description, "stiffness", "1e9");
  description = WithValue(description, "max_torque", "1e9");
  std::ofstream(robot / "robot.toml") << description;
  const ScopedEnvironment robots("TASKC_ROBOT_PATH", folder() / "robots");
  const ProgramResult result = Trainer({"train", TaskFile("leaning"), "--profile", "paper",
                                        "--episodes", "2", "--out", RunFolder("run")});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_THAT(result.errors, HasSubstr("warning: episode 2: the simulation diverged"));
  EXPECT_THAT(result.output, HasSubstr("best none"));
  const std::vector<EpisodeRecord> episodes =
      RunDatabase::OpenToRead(RunFolder("run")).ReadEpisodes();
  ASSERT_EQ(episodes.size(), 2u);
  EXPECT_EQ(episodes[1].active.end_kind, "diverged");
}

// Where some starts would have links inside each other, others are drawn; where all would, the
// episode is over at once.
TEST_F(FailureTest, EndsEpisodesForWhichThereIsNoStart) {
  const auto train = [&](const std::string& name, const std::string& least) {
    const ProgramResult result =
        Trainer({"train", TaskFile("striding"), "--profile", "fast-tree", "--episodes", "5",
                 "--quiet", "--set", "task.least=" + least, "--out", RunFolder(name)});
    EXPECT_EQ(result.exit_status, 0) << result.errors;
    return result.errors;
  };
  EXPECT_EQ(train("some", "-1"), "");
  EXPECT_THAT(train("all", "0.2"),
              HasSubstr("warning: episode 5: links overlap in each of 100 starts that were drawn: "
                        "`left_ankle` and `right_ankle` by "));
  for (const EpisodeRecord& episode : RunDatabase::OpenToRead(RunFolder("all")).ReadEpisodes()) {
    EXPECT_EQ(episode.steps, 0);
    EXPECT_EQ(episode.active.end_kind, "diverged");
    EXPECT_EQ(episode.active.episode_return, 0);
  }
}

TEST_F(FailureTest, KeepsWhatWasSavedWhenTheDiskIsFull) {
  std::vector<std::string> words = {"/bin/sh", "-c", "ulimit -f 400; exec \"$@\"", "sh", TRAINER};
  const std::vector<std::string> training =
      Training("run", 1000, {"--record-every", "1", "--json"});
  words.insert(words.end(), training.begin(), training.end());
  const ProgramResult failed = RunProgram(words);
  EXPECT_EQ(failed.exit_status, 1);
  EXPECT_THAT(failed.errors, AllOf(HasSubstr("run.db"), HasSubstr("cannot save episode"),
                                   HasSubstr("trainer resume " + RunFolder("run"))));
  const auto shown = std::count(failed.output.begin(), failed.output.end(), '\n');
  EXPECT_GT(shown, 0);
  EXPECT_EQ(RunDatabase::OpenToRead(RunFolder("run")).ReadEpisodes().size(),
            static_cast<size_t>(shown));
  const ProgramResult resumed = Trainer({"resume", RunFolder("run"), "--episodes", "3", "--quiet"});
  ASSERT_EQ(resumed.exit_status, 0) << resumed.errors;
  Train("uninterrupted", 3, {"--record-every", "1", "--quiet"});
  ExpectEqual(TraceOf("run"), TraceOf("uninterrupted"));
}

TEST_F(FailureTest, StopsAtOnceAtTheSecondCtrlC) {
  ChildProcess trainer(
      {TRAINER, "train", TaskFile("patient"), "--profile", "paper", "--out", RunFolder("run")});
  ASSERT_NO_FATAL_FAILURE(WaitForAStep("run"));
  trainer.Send(SIGINT);
  ASSERT_TRUE(trainer.WaitForError("stopping after this episode"));
  trainer.Send(SIGINT);
  EXPECT_EQ(trainer.Wait().signal, SIGINT);
  EXPECT_EQ(RunDatabase::OpenToRead(RunFolder("run")).ReadState(), RunState::kInterrupted);
}

}  // namespace
}  // namespace runtime
