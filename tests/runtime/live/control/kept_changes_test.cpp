// What was changed in a run, and then a kill or a full disk.
#include <sys/resource.h>

#include <csignal>

#include "runtime/live/control/journal.h"
#include "tests/runtime/live/control/live_run_test.h"
#include "tests/runtime/training/run/error_of.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

// The episode is repeated with fewer steps than it had when the changes were made.
class LateChangeTest : public LiveRunTest {
 protected:
  void SetUp() override {
    Begin(100).Run(2, "episode");
    trainer_->Run(10, "step");
    EXPECT_EQ(trainer_->Ask("swap", Swap("other", false))["takes_effect"], "episode 4");
    trainer_->Ask("set", {{"name", "task.gain"}, {"value", 2}});
    trainer_->Ask("load", {{"file", PluginFile("other").string()}, {"name", "shadow"}});
    Kill();
    Begin(100).Ask("set", {{"name", "task.limit"}, {"value", 0.05}});
    EXPECT_EQ(trainer_->Position(), std::pair(3L, 0L));
    trainer_->Run(1, "episode");
    EXPECT_EQ(trainer_->database().ReadEpisodes().back().steps, 8);
  }
  void ExpectItsEffect() {
    EXPECT_EQ(trainer_->Position(), std::pair(4L, 0L));
    EXPECT_EQ(trainer_->Ask("get", {{"name", "task.gain"}})["value"], 2);
    EXPECT_EQ(trainer_->Ask("list")["tasks"].size(), 2u);
    EXPECT_THAT(trainer_->Changes(),
                ElementsAre("3:0 set task.limit = 0.05", "4:0 set task.gain = 2",
                            HasSubstr("4:0 load load shadow"), HasSubstr("4:0 swap swap task")));
  }
};

TEST_F(LateChangeTest, IsNotLostWithTheNextKill) {
  ExpectItsEffect();
  trainer_->Run(3, "step");
  Kill();
  Begin(100);
  ExpectItsEffect();
  ExpectTheSameFromTheRecord(6);
}

TEST_F(LateChangeTest, NorWithAKillBetweenTheCheckpointAndTheNextStep) {
  Kill();
  SqliteDatabase(folder_.path() / "run" / "run.db", SqliteAccess::kWrite)
      .Execute(
          "UPDATE change SET episode = 3, step = 10 WHERE kind IN ('set', 'load') AND step = 0 "
          "AND episode = 4",
          "as it was before the fourth episode");
  Begin(100);
  ExpectItsEffect();
  ExpectTheSameFromTheRecord(6);
}

TEST_F(LiveRunTest, WhatCannotBeDoneAgainIsNeverTriedOnceMore) {
  Begin(100).Run(10, "step");
  trainer_->Ask("load", {{"file", PluginFile("other").string()}, {"name", "shadow"}});
  Kill();
  Begin(100).Run(2, "step");
  trainer_->Ask("load", {{"file", PluginFile("steady").string()}, {"name", "shadow"}});
  trainer_->Run(1, "episode");
  EXPECT_EQ(
      trainer_->Changes().back(),
      "1:10 quarantine taken back: load shadow: other () (there is a module `shadow` already)");
  trainer_->Run(3, "step");
  Kill();
  EXPECT_EQ(Begin(100).Ask("list")["tasks"][1]["task"], "steady");
  EXPECT_THAT(trainer_->Changes(), SizeIs(3));
  ExpectTheSameFromTheRecord(4);
}

// What follows from a change that is taken back cannot be done either: here, that the first task
// went.
TEST_F(LiveRunTest, ATaskThatWasReplacedComesBackWhereTheOtherIsTakenOut) {
  Begin(100).Ask("load", {{"file", PluginFile("other").string()}, {"name", "shadow"}});
  trainer_->Run(1, "episode");
  trainer_->Ask("promote", {{"name", "shadow"}});
  trainer_->Run(1, "episode");
  trainer_->Ask("unload", {{"name", "task"}});
  trainer_->Run(1, "episode");
  Kill();
  {
    RunDatabase database = RunDatabase::Open(folder_.path() / "run");
    QuarantineTask(database, 2, "crash");
  }
  for (int64_t episodes : {4, 5}) {
    const json tasks = Begin(100).Ask("list")["tasks"];
    ASSERT_EQ(tasks.size(), 1u);
    EXPECT_EQ(tasks[0]["module"], "task");
    EXPECT_EQ(tasks[0]["role"], "active");
    trainer_->Run(1, "episode");
    EXPECT_EQ(trainer_->database().ReadEpisodes().back().number, episodes);
    Kill();
  }
}

TEST_F(LiveRunTest, ARunDoesNotGoOnWithoutAPluginThatIsGone) {
  Begin(100).Ask("swap", Swap("other", true));
  trainer_->Run(1, "episode");
  const std::filesystem::path plugin = folder_.path() / "run" / trainer_->record().tasks[1].plugin;
  Kill();
  std::filesystem::rename(plugin, folder_.path() / "away");
  EXPECT_THAT(ErrorOf([&] { trainer_.emplace(folder_.path() / "run", 100, WhenDone::kWait); }),
              AllOf(HasSubstr(plugin.string()), HasSubstr("is gone")));
  std::filesystem::rename(folder_.path() / "away", plugin);
  EXPECT_EQ(Begin(100).Ask("list")["tasks"][0]["task"], "other");
}

// While it lives, no file of this process may become larger than `file` is.
class FullDisk {
 public:
  explicit FullDisk(const std::filesystem::path& file) {
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = std::filesystem::file_size(file);
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int) = std::signal(SIGXFSZ, SIG_IGN);
};

TEST_F(LiveRunTest, WhatCannotBeWrittenDownIsNotDone) {
  Begin(100).Run(1, "episode");
  trainer_->Ask("swap", Swap("other", false));
  trainer_->Run(1, "episode");
  trainer_->Run(3, "step");
  const std::string graph = trainer_->Ask("graph")["text"];
  {
    const FullDisk full(folder_.path() / "run" / "run.db-wal");
    const std::pair<const char*, json> requests[] = {
        {"set", {{"name", "task.gain"}, {"value", 2}}},
        {"set", {{"name", "task.gain"}, {"from", 2}, {"to", 4}, {"episodes", 3}}},
        {"module_add", {{"type", "Reader"}, {"name", "reader"}}},
        {"disconnect", {{"first", "mind.end_of_action"}, {"second", "task.on_end_of_action"}}},
        {"load", {{"file", PluginFile("bare").string()}, {"name", "shadow"}}},
        {"swap", Swap("steady", true)},
        {"swap", Swap("steady", false)},
        {"rollback", {{"name", "task"}, {"now", true}}},
    };
    for (const auto& [command, arguments] : requests) {
      EXPECT_THAT(trainer_->Refusal(command, arguments), HasSubstr("run.db: cannot note a "))
          << command;
    }
  }
  EXPECT_EQ(trainer_->Ask("graph")["text"], graph);
  EXPECT_EQ(trainer_->Ask("get", {{"name", "task.gain"}})["value"], 1);
  EXPECT_THAT(trainer_->Ask("list")["schedules"], IsEmpty());
  EXPECT_EQ(trainer_->Ask("list")["tasks"][0]["task"], "other");
  EXPECT_THAT(trainer_->Changes(), SizeIs(1));
  trainer_->Ask("set", {{"name", "task.count"}, {"value", 3}});  // there is space again
  trainer_->Run(1, "episode");
  Kill();
  EXPECT_EQ(Begin(100).Ask("graph")["text"], graph);
  ExpectTheSameFromTheRecord(5);
}

TEST_F(LiveRunTest, AChangeThatFailsIsTakenOutOfTheJournal) {
  Begin(100).Run(1, "step");
  trainer_->Refusal("connect", {{"first", "task.reward"}, {"second", "learner.reward"}});
  EXPECT_THAT(trainer_->Changes(), IsEmpty());
}

}  // namespace
}  // namespace runtime
