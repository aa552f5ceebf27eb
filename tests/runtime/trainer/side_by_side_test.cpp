// Runs whose episodes are run side by side: whatever is done with them, all that comes of them is
// the same, bit for bit, as if their episodes had been run one at a time.
#include <gmock/gmock.h>

#include <functional>

#include "runtime/training/run/sqlite.h"
#include "tests/runtime/trainer/learner_run.h"

namespace runtime {
namespace {

using nlohmann::json;
using testing::Each;
using testing::SizeIs;

// Where the second trace first differs from the first one; "" where it does not.
std::string Difference(const std::vector<std::string>& expected,
                       const std::vector<std::string>& trace) {
  if (expected.size() != trace.size()) return "one of the runs has more episodes";
  for (size_t i = 0; i < expected.size(); ++i) {
    if (trace[i] == expected[i]) continue;
    if (i % 2 == 0 && i + 1 < expected.size()) return trace[i] + "\nand not\n" + expected[i];
    return fmt::format("the recording of episode {}, or the checkpoint", i / 2 + 1);
  }
  return "";
}

// By the agent that learns.
class SideBySideTest : public LearnerRunTest, public testing::WithParamInterface<std::string> {
 protected:
  SideBySideTest() : LearnerRunTest(Options(GetParam())) {}

  // The trace of a run of `jobs` episodes at a time, in which this was done; each has a name of its
  // own.
  std::vector<std::string> Trace(int jobs,
                                 const std::function<void(const std::string& run)>& work) {
    const std::string run = fmt::format("run{}", ++runs_);
    UseJobs(jobs);
    work(run);
    return TraceOf(run);
  }
  void ExpectTheSame(const std::function<void(const std::string& run)>& work) {
    const std::vector<std::string> one = Trace(1, work);
    for (const int jobs : {2, 3}) EXPECT_EQ(Difference(one, Trace(jobs, work)), "") << jobs;
  }

  // Goes on with a run, waits until its episodes are done, and then does this.
  void Serve(const std::string& run, int64_t episodes,
             const std::function<void(const ServedRun&)>& work) const {
    const ServedRun served(Run(run),
                           [&] { return Resume(run, episodes, LiveRun::WhenDone::kWait); });
    work(served);
  }
  static void GoOn(const ServedRun& run, int64_t episodes) {
    run.Request("resume", {{"episodes", episodes}});
    run.WaitUntilDone();
  }
  // Makes the run begin again with what is left of it: the journal of what was done to it.
  void ForgetCheckpoint(const std::string& run) const {
    SqliteDatabase database(Run(run) / "run.db", SqliteAccess::kWrite);
    database.Execute("DELETE FROM checkpoint", "forget the checkpoint");
  }

 private:
  static TaskOptions Options(const std::string& agent) {
    TaskOptions options{.task = PluginFile("swaying"),
                        .profile = "fast",
                        .agent = agent,
                        .robot = "humanoid",
                        .settings = {}};
    if (agent == "ppo") {
      options.settings = {"learner.hidden=[8, 8]", "learner.batch=25", "learner.minibatch=8",
                          "learner.deviation=0.5", "learner.deviation_decisions=1000"};
    } else {
      options.settings = {"learner.population=5", "action_space.harmonics=1"};
    }
    return options;
  }

  int runs_ = 0;
};

TEST_P(SideBySideTest, HowManyAreRunAtATimeDoesNotMatter) {
  ExpectTheSame([&](const std::string& run) { ASSERT_EQ(Train(run, 23), 0); });
  const std::vector<EpisodeRecord> episodes = EpisodesOf("run3");
  ASSERT_THAT(episodes, SizeIs(23));
  for (const EpisodeRecord& episode : episodes) {
    EXPECT_GT(episode.wall_seconds, 0);
    EXPECT_GT(episode.cpu_seconds, 0);
    EXPECT_THAT(episode.active.goals, SizeIs(1));
  }
}

TEST_P(SideBySideTest, ARunGoesOnWithAnotherNumberOfThem) {
  const auto whole = Trace(1, [&](const std::string& run) { ASSERT_EQ(Train(run, 20), 0); });
  const auto parts = Trace(3, [&](const std::string& run) {
    ASSERT_EQ(Train(run, 2), 0);
    UseJobs(2);
    ASSERT_EQ(Resume(run, 9), 0);
    UseJobs(1);
    ASSERT_EQ(Resume(run, 11), 0);
    UseJobs(4);
    ASSERT_EQ(Resume(run, 20), 0);
  });
  EXPECT_EQ(Difference(whole, parts), "");
}

TEST_P(SideBySideTest, WhatIsChangedBetweenEpisodesHoldsForAllThatFollow) {
  ExpectTheSame([&](const std::string& run) {
    ASSERT_EQ(Train(run, 3), 0);
    Serve(run, 4, [](const ServedRun& served) {
      served.Request("load", {{"file", PluginFile("seeing")}, {"name", "shadow"}});
      served.Request("set", {{"name", "task.gain"}, {"value", 3.5}});
      GoOn(served, 9);
      served.Request("swap", {{"name", "task"}, {"file", PluginFile("swaying_less")}});
      served.Request("hold", {{"name", "task.limit"}, {"value", 0.25}});
      GoOn(served, 14);
      served.Request("rollback", {{"name", "task"}});
      served.Request("unload", {{"name", "shadow"}});
      GoOn(served, 18);
    });
  });
  const std::vector<EpisodeRecord> episodes = EpisodesOf("run3");
  EXPECT_THAT(episodes[7].shadows, SizeIs(1));
  EXPECT_EQ(episodes[12].active.goals.at(0).value, std::vector<double>{0.25});
  EXPECT_THAT(episodes[17].shadows, SizeIs(0));
}

TEST_P(SideBySideTest, AScheduleMovesFromEpisodeToEpisode) {
  ExpectTheSame([&](const std::string& run) {
    ASSERT_EQ(Train(run, 2), 0);
    Serve(run, 3, [](const ServedRun& served) {
      served.Request("set", {{"name", "task.gain"}, {"from", 5}, {"to", 1}, {"episodes", 8}});
      GoOn(served, 16);
    });
  });
}

TEST_P(SideBySideTest, ASignalThatIsAddedIsHeardByAll) {
  ExpectTheSame([&](const std::string& run) {
    ASSERT_EQ(Train(run, 2), 0);
    Serve(run, 3, [](const ServedRun& served) {
      served.Request("module_add",
                     {{"type", "SignalGenerator"},
                      {"name", "unheard"},
                      {"parameters", {{"sensor", "wish"}, {"unit", "m/s"}, {"value", {0.5}}}}});
      GoOn(served, 10);
    });
  });
}

// Such an episode is run alone, as often as it is repeated.
TEST_P(SideBySideTest, WhatIsDoneWithinAnEpisodeIsRepeatedThere) {
  int64_t last = 0;
  const auto live = Trace(3, [&](const std::string& run) {
    ASSERT_EQ(Train(run, 3), 0);
    Serve(run, 4, [&](const ServedRun& served) {
      served.Request("resume", {{"episodes", 100'000}});
      served.Request("pause", json::object());
      json status;
      do {
        served.Request("step", {{"count", 3}});
        do {
          status = served.Request("status", json::object());
        } while (status["state"] != "paused");
      } while (status["step"] == 0);
      served.Request("set", {{"name", "task.gain"}, {"value", 0.5}});
      last = status["episode"].get<int64_t>() + 7;
      GoOn(served, last);
    });
  });
  for (const int jobs : {1, 3}) {
    UseJobs(jobs);
    ForgetCheckpoint("run1");
    ASSERT_EQ(Resume("run1", last), 0);
    EXPECT_EQ(Difference(live, TraceOf("run1")), "") << jobs;
  }
}

TEST_P(SideBySideTest, ARunThatIsStoppedGoesOnAsIfItHadNotBeen) {
  int64_t last = 0;
  const auto stopped = Trace(3, [&](const std::string& run) {
    ASSERT_EQ(Train(run, 3), 0);
    Serve(run, 4, [](const ServedRun& served) {
      served.Request("resume", {{"episodes", 100'000}});
      served.Request("pause", json::object());
      served.Request("resume", json::object());
    });
    last = static_cast<int64_t>(EpisodesOf(run).size()) + 5;
    ASSERT_EQ(Resume(run, last), 0);
  });
  const auto whole = Trace(1, [&](const std::string& run) { ASSERT_EQ(Train(run, last), 0); });
  EXPECT_EQ(Difference(whole, stopped), "");
}

TEST_P(SideBySideTest, ATaskThatRemembersEpisodesHasThemOneAfterTheOther) {
  task().task = PluginFile("leaning");
  ExpectTheSame([&](const std::string& run) { ASSERT_EQ(Train(run, 8), 0); });
}

INSTANTIATE_TEST_SUITE_P(Agents, SideBySideTest, testing::Values("ppo", "motion_search"),
                         [](const auto& each) { return each.param; });

}  // namespace
}  // namespace runtime
