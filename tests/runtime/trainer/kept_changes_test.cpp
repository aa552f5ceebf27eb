// What was changed in a running trainer, and then a kill, a full disk or another program at the
// run's database.
#include <sys/resource.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <random>
#include <thread>

#include "tests/runtime/trainer/live_test.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

class KeptChangesTest : public LiveTest {
 protected:
  // From now on the trainer can write no file beyond the size that the database's log has.
  void FillTheDisk() { LimitFiles(std::filesystem::file_size(folder() / "run" / "run.db-wal")); }
  void FreeTheDisk() { LimitFiles(RLIM_INFINITY); }

 private:
  void LimitFiles(rlim_t size) {
    const auto process = Ask({"status"})["pid"].get<pid_t>();
    const rlimit limit{size, RLIM_INFINITY};
    ASSERT_EQ(prlimit(process, RLIMIT_FSIZE, &limit, nullptr), 0);
  }
};

TEST_F(KeptChangesTest, ASignalIsAddedForATaskThatReadsIt) {
  const std::string task = (folder() / "wishing.task").string();
  std::ofstream(task)
      << "task wishing for humanoid\nsensor wish: real [m/s]\n"
         "on end_of_time_step {\n  reward rate near = -abs(wish - base.velocity.x)\n"
         "  if time > 0.3 s { truncate_episode \"time is up\" }\n}\n";
  const std::string file = (folder() / "wish.csv").string();
  std::ofstream(file) << "time [s], wish [m/s]\n0, 0.1\n0.3, 0.4\n";
  Serve(100, {"--checkpoint-every", "0", "--record-every", "1"});
  EXPECT_THAT(Refusal({"swap", "task", task}),
              AllOf(HasSubstr("reads the sensor `wish`, and no module has an out port `wish`"),
                    HasSubstr("module add SignalGenerator wish sensor=wish")));
  Ask({"module", "add", "SignalGenerator", "wish", "sensor=wish", "unit=m/s", "signal=samples",
       "file=" + file});
  std::filesystem::remove(file);
  Ask({"swap", "task", task, "--now"});
  RunEpisodes(2);
  Ask({"set", "wish.signal", "constant"});
  Ask({"set", "wish.value", "0.25 m/s"});
  EXPECT_THAT(Refusal({"set", "wish.sensor", "other"}), HasSubstr("has no effect any more"));
  EXPECT_THAT(Refusal({"module", "remove", "wish"}), HasSubstr("is read by `task.wish`"));
  RunEpisodes(2);
  Stop();
  ExpectTheSameFromTheRecord(8);
}

// A task's own sensor without any module, told anew while it runs.
TEST_F(KeptChangesTest, WhatATasksOwnSensorIsToldIsRepeated) {
  const std::string task = (folder() / "wishing.task").string();
  std::ofstream(task) << "task wishing for humanoid\nsensor wish: real [m/s] in 0 m/s .. 1 m/s\n"
                         "sensor ball.place: vec2 [m]\non end_of_time_step {\n"
                         "  reward rate near = -abs(wish - base.velocity.x)\n"
                         "  reward rate far = norm(ball.place - base.position.xy) / 1 m\n"
                         "  if time > 0.3 s { truncate_episode \"time is up\" }\n}\n";
  Serve(100,
        {"--checkpoint-every", "0", "--record-every", "1", "--set", "task.wish=0.25", "--set",
         "task.ball.place=[1, 0.5]"},
        task);
  RunEpisodes(2);
  EXPECT_EQ(Ask({"get", "task.wish"})["value"], json({0.25}));
  Ask({"set", "task.wish", "0.5 m/s"});
  Ask({"set", "task.ball.place", "[2, -1]"});
  RunEpisodes(2);
  EXPECT_THAT(Refusal({"set", "task.wish", "2"}), HasSubstr("must lie in 0 .. 1"));
  EXPECT_THAT(Refusal({"set", "task.wish", "0.5 m"}), HasSubstr("in m/s"));
  EXPECT_THAT(Refusal({"set", "task.ball.place", "1"}), HasSubstr("with 2 elements, not 1"));
  Ask({"load", task, "as", "shadow"});
  Ask({"swap", "task", task, "--forget"});
  RunEpisodes(2);
  const EpisodeRecord episode = Episodes().back();
  ASSERT_THAT(episode.shadows, SizeIs(1));
  // The same but for the order of the sums.
  EXPECT_NEAR(episode.shadows[0].episode_return, episode.active.episode_return, 1e-12);
  Kill();
  ServeAgain();
  EXPECT_EQ(Ask({"get", "task.ball.place"})["value"], json({2.0, -1.0}));
  RunOneMoreEpisode();
  Stop();
  ExpectTheSameFromTheRecord(10);
}

TEST_F(KeptChangesTest, AChangeThatTakesEffectLaterSurvivesTheNextKill) {
  Serve(100, {"--checkpoint-every", "0", "--record-every", "1"});
  Ask({"swap", "task", TaskFile("upright"), "--now"});
  Ask({"set", "task.limit", "0.4 s"});
  RunEpisodes(1);
  RunSteps(70);
  const int64_t episode = Ask({"status"})["episode"];
  Ask({"set", "task.gain", "3"});
  Ask({"load", TaskFile("leaning"), "as", "shadow"});
  Kill();
  ServeAgain();
  EXPECT_EQ(Ask({"status"})["episodes_done"], episode - 1);
  Ask({"set", "task.limit", "0.2 s"});
  RunOneMoreEpisode();
  ASSERT_LT(Episodes().back().steps, 70);
  for (int kills = 0; kills < 2; ++kills) {
    EXPECT_EQ(Ask({"get", "task.gain"})["value"], 3);
    EXPECT_EQ(TaskNamed("shadow")["task"], "leaning");
    const std::string next = std::to_string(episode + 1);
    EXPECT_THAT(Changes(),
                ElementsAre(HasSubstr(":0 swap"), HasSubstr(":0 set"),
                            std::to_string(episode) + ":0 set", next + ":0 set", next + ":0 load"));
    Kill();
    ServeAgain();
  }
  EXPECT_EQ(Stop().exit_status, 0);
  ExpectTheSameFromTheRecord(12);
}

TEST_F(KeptChangesTest, WhatIsRefusedOnAFullDiskIsNotDone) {
  Serve(100, {"--checkpoint-every", "0"});
  const std::string graph = Ask({"graph"})["text"];
  FillTheDisk();
  EXPECT_THAT(Refusal({"module", "add", "NgNet", "net"}),
              AllOf(HasSubstr("run.db: cannot note a change")));
  EXPECT_THAT(Refusal({"set", "task.limit", "0.1 s"}), HasSubstr("cannot note a change"));
  EXPECT_THAT(Refusal({"swap", "task", TaskFile("upright"), "--now"}), HasSubstr("cannot"));
  FreeTheDisk();
  EXPECT_EQ(Ask({"graph"})["text"], graph);
  EXPECT_EQ(Ask({"get", "task.limit"})["value"], 0.3);
  EXPECT_THAT(Changes(), IsEmpty());
  RunEpisodes(2);
  Kill();
  ExpectTheSameFromTheRecord(6);
}

TEST_F(KeptChangesTest, NobodyIsToBlameForAFullDisk) {
  Serve(1000, {"--checkpoint-every", "0"});
  Ask({"set", "task.limit", "0.1 s"});
  FillTheDisk();
  Ctl({"resume"});  // may have no time to answer
  const ProgramResult failed = trainer_->Wait();
  EXPECT_EQ(failed.exit_status, 1);
  EXPECT_THAT(failed.errors, AllOf(HasSubstr("run.db: cannot save episode"),
                                   HasSubstr("trainer resume"), Not(HasSubstr("undone"))));
  EXPECT_THAT(Changes(), ElementsAre(HasSubstr(":0 set")));
  ExpectTheSameFromTheRecord(6);
}

TEST_F(KeptChangesTest, NorForAProgramThatLocksTheDatabaseForAWhile) {
  Serve(1000, {"--checkpoint-every", "0"});
  Ask({"set", "task.limit", "0.1 s"});
  {
    SqliteDatabase other(folder() / "run" / "run.db", SqliteAccess::kWrite);
    other.Execute("BEGIN IMMEDIATE", "lock it");
    Ctl({"resume"});
    std::this_thread::sleep_for(std::chrono::milliseconds(2600));
    other.Execute("ROLLBACK", "free it");
  }
  EXPECT_GE(Ask({"save"})["episode"], 2);
  EXPECT_THAT(Changes(), ElementsAre(HasSubstr(":0 set")));
  EXPECT_EQ(Stop().exit_status, 0);
}

// At random moments, of which some are while it starts, saves or changes. TRAINER_KILLS: how often.
TEST_F(KeptChangesTest, ARunThatIsKilledAgainAndAgainIsTheRunOfItsRecord) {
  const char* wanted = std::getenv("TRAINER_KILLS");
  const int kills = wanted == nullptr ? 6 : std::atoi(wanted);
  std::mt19937 random(7);
  const auto choose = [&](auto... words) {
    const std::vector<std::string> all = {words...};
    return all[random() % all.size()];
  };
  Serve(1'000'000, {"--checkpoint-every", "0.05", "--record-every", "1"});
  for (int kill = 0; kill < kills; ++kill) {
    Ctl({"resume"});
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(random() % 700);
    std::jthread client([&] {  // whatever is refused, or not answered any more
      while (std::chrono::steady_clock::now() < end) {
        const std::string task = TaskFile(choose("leaning", "upright"));
        switch (random() % 6) {
          case 0:
            Ctl({"set", "task.limit", choose("0.1 s", "0.2 s", "0.5 s", "1 s")});
            break;
          case 1:
            Ctl({"swap", "task", task, choose("--now", "--forget")});
            break;
          case 2:
            Ctl({"load", task, "as", "shadow"});
            break;
          case 3:
            Ctl({choose("promote", "unload"), choose("shadow", "task")});
            break;
          case 4:
            Ctl({"set", "learner.temperature", "=", choose("2", "1"), "->", "0.5", "over",
                 choose("3", "9"), "episodes"});
            break;
          default:
            Ctl({"rollback", "task", "--now"});
        }
      }
    });
    std::this_thread::sleep_until(end);
    Kill();
    client.join();
    trainer_.emplace(std::vector<std::string>{TRAINER, "serve", RunFolder("run"), "--json"});
    if (random() % 4 != 0) WaitForState("running");
  }
  Kill();
  const auto done = RunDatabase::OpenToRead(RunFolder("run")).ReadEpisodes().size();
  RecordProperty("episodes", static_cast<int>(done));
  RecordProperty("changes", static_cast<int>(Changes().size()));
  ExpectTheSameFromTheRecord(static_cast<int>(done) + 3);
}

}  // namespace
}  // namespace runtime
