#include <sqlite3.h>

#include <csignal>
#include <filesystem>

#include "tests/runtime/trainer/trainer_test.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class ResumeTest : public TrainerTest {
 protected:
  // Starts a training that is far too long, waits for three episodes and sends the signal.
  ProgramResult StopAfterThreeEpisodes(const std::string& name, int signal,
                                       const std::string& checkpoint_seconds) const {
    std::vector<std::string> words =
        Training(name, 100'000, {"--json", "--checkpoint-every", checkpoint_seconds});
    words.insert(words.begin(), TRAINER);
    ChildProcess trainer(words);
    EXPECT_TRUE(trainer.WaitForLines(3));
    trainer.Send(signal);
    return trainer.Wait();
  }

  // Lets the run go on to a few episodes more than it has; returns how many these are in all.
  int GoOn(const std::string& name) const {
    const auto done = RunDatabase::OpenToRead(RunFolder(name)).ReadEpisodes().size();
    const int episodes = static_cast<int>(done) + 4;
    const ProgramResult result =
        Trainer({"resume", RunFolder(name), "--episodes", std::to_string(episodes), "--quiet"});
    EXPECT_EQ(result.exit_status, 0) << result.errors;
    return episodes;
  }

  void ExpectAsIfNeverStopped(const std::string& name, int episodes) const {
    Train("uninterrupted", episodes, {"--quiet"});
    const Trace trace = TraceOf(name);
    EXPECT_EQ(trace.episodes.size(), static_cast<size_t>(episodes));
    ExpectEqual(trace, TraceOf("uninterrupted"));
  }
};

TEST_F(ResumeTest, GoesOnBitForBitAfterAKill) {
  const ProgramResult killed = StopAfterThreeEpisodes("run", SIGKILL, "0");
  EXPECT_EQ(killed.signal, SIGKILL);
  ExpectAsIfNeverStopped("run", GoOn("run"));
}

TEST_F(ResumeTest, RunsTheEpisodesAfterTheCheckpointAgain) {
  StopAfterThreeEpisodes("run", SIGKILL, "0");
  {  // as if the last two episodes had come after the checkpoint of the one before them
    Train("short", 1, {"--quiet"});
    const RunDatabase early = RunDatabase::OpenToRead(RunFolder("short"));
    RunDatabase::Open(RunFolder("run")).WriteCheckpoint(early.ReadCheckpoint().value());
  }
  ExpectAsIfNeverStopped("run", GoOn("run"));
}

TEST_F(ResumeTest, StartsAnewWhereThereIsNoCheckpointYet) {
  StopAfterThreeEpisodes("run", SIGKILL, "1000");
  EXPECT_FALSE(RunDatabase::OpenToRead(RunFolder("run")).ReadCheckpoint().has_value());
  ExpectAsIfNeverStopped("run", GoOn("run"));
}

TEST_F(ResumeTest, GoesOnAfterCtrlC) {
  const ProgramResult stopped = StopAfterThreeEpisodes("run", SIGINT, "1000");
  EXPECT_EQ(stopped.exit_status, 128 + SIGINT);
  EXPECT_THAT(stopped.errors, HasSubstr("stopping after this episode"));
  {
    const RunDatabase database = RunDatabase::OpenToRead(RunFolder("run"));
    EXPECT_EQ(database.ReadState(), RunState::kInterrupted);
    EXPECT_EQ(database.ReadCheckpoint()->episode,
              static_cast<int64_t>(database.ReadEpisodes().size()));
  }
  ExpectAsIfNeverStopped("run", GoOn("run"));
}

TEST_F(ResumeTest, NeedsNothingButTheRunsFolder) {
  std::filesystem::copy_file(TaskFile("leaning"), folder() / "leaning.task");
  const ProgramResult trained =
      Trainer({"train", (folder() / "leaning.task").string(), "--profile", "fast", "--episodes",
               "2", "--quiet", "--out", RunFolder("run")});
  ASSERT_EQ(trained.exit_status, 0) << trained.errors;
  std::filesystem::remove(folder() / "leaning.task");
  ExpectAsIfNeverStopped("run", GoOn("run"));
}

TEST_F(ResumeTest, HasNothingToDoWhereAllEpisodesAreDone) {
  Train("run", 2, {"--quiet"});
  const Trace before = TraceOf("run");
  const ProgramResult result = Trainer({"resume", RunFolder("run")});
  EXPECT_EQ(result.exit_status, 0);
  EXPECT_THAT(result.output, AllOf(HasSubstr("all 2 episodes"), HasSubstr("--episodes")));
  ExpectEqual(before, TraceOf("run"));
}

TEST_F(ResumeTest, LeavesARunThatIsDoneAsItIs) {
  Train("run", 1, {"--quiet"});
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open((RunFolder("run") + "/run.db").c_str(), &database), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(database, "UPDATE run SET value = 'long ago' WHERE key = 'finished_at'",
                         nullptr, nullptr, nullptr),
            SQLITE_OK);
  sqlite3_close(database);
  const ProgramResult result = Trainer({"resume", RunFolder("run")});
  EXPECT_EQ(result.exit_status, 0);
  EXPECT_THAT(result.output, HasSubstr("all 1 episodes of this run are done"));
  EXPECT_EQ(RunDatabase::OpenToRead(RunFolder("run")).ReadValue("finished_at"), "long ago");
}

TEST_F(ResumeTest, RefusesToForgetEpisodes) {
  Train("run", 3, {"--quiet"});
  const ProgramResult result = Trainer({"resume", RunFolder("run"), "--episodes", "2"});
  EXPECT_EQ(result.exit_status, 2);
  EXPECT_THAT(result.errors, HasSubstr("has 3 episodes already"));
}

TEST_F(ResumeTest, MissesAPluginThatIsGone) {
  Train("run", 1, {"--quiet"});
  const std::string plugin =
      RunDatabase::OpenToRead(RunFolder("run")).ReadRun().tasks.front().plugin;
  std::filesystem::remove(std::filesystem::path(RunFolder("run")) / plugin);
  const ProgramResult result = Trainer({"resume", RunFolder("run"), "--episodes", "2"});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, AllOf(HasSubstr(plugin), HasSubstr("is gone")));
}

TEST_F(ResumeTest, ReportsADamagedCheckpoint) {
  Train("run", 1, {"--quiet"});
  RunDatabase::Open(RunFolder("run")).WriteCheckpoint({1, "no checkpoint at all"});
  const ProgramResult result = Trainer({"resume", RunFolder("run"), "--episodes", "2"});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, AllOf(HasSubstr("checkpoint"), HasSubstr("damaged")));
}

TEST_F(ResumeTest, RefusesARunThatIsTrainedAlready) {
  std::vector<std::string> words = Training("run", 100'000, {"--json"});
  words.insert(words.begin(), TRAINER);
  ChildProcess trainer(words);
  ASSERT_TRUE(trainer.WaitForLines(1));
  const ProgramResult result = Trainer({"resume", RunFolder("run")});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, HasSubstr("another trainer"));
}

}  // namespace
}  // namespace runtime
