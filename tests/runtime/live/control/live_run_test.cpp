#include "tests/runtime/live/control/live_run_test.h"

#include <fstream>

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

TEST_F(LiveRunTest, StandsStillWhereItIsTold) {
  Trainer& run = Begin(100);
  EXPECT_EQ(run.Position(), std::pair(1L, 0L));
  run.Run(1, "step");
  EXPECT_EQ(run.Position(), std::pair(1L, 1L));
  run.Run(kStepsOfAnEpisode - 2, "step");
  EXPECT_EQ(run.Position(), std::pair(1L, 11L));
  run.Run(1, "step");
  EXPECT_EQ(run.Position(), std::pair(2L, 0L));
  run.Run(1, "episode");
  EXPECT_EQ(run.Position(), std::pair(3L, 0L));
  run.Run(5, "step");
  run.Run(2, "episode");  // what is left of this one, and another
  EXPECT_EQ(run.Position(), std::pair(5L, 0L));
  EXPECT_EQ(run.Refusal("step", {{"count", 0}}), "`count` must be at least 1");
  EXPECT_EQ(run.Refusal("step", {{"unit", "steps"}}),
            "`steps` is not a unit: did you mean `step`?");
  EXPECT_THAT(run.events.Of("episode", "episode"), ElementsAre(1, 2, 3, 4));
}

TEST_F(LiveRunTest, SaysWhenItsStateChanges) {
  Trainer& run = Begin(3);
  EXPECT_EQ(run.Ask("pause")["state"], "paused");  // once more
  EXPECT_EQ(run.Ask("resume")["state"], "running");
  run.WaitFor("finished");
  EXPECT_THAT(run.events.Of("state", "state"), ElementsAre("paused", "running", "finished"));
  EXPECT_EQ(run.Position(), std::pair(3L, 0L));  // there is no fourth one
}

TEST_F(LiveRunTest, AStopDuringAPauseEndsTheEpisodeFirst) {
  Trainer& run = Begin(100);
  run.Run(5, "step");
  EXPECT_EQ(run.Ask("stop")["stops"], "after episode 1");
  run.Wait();
  EXPECT_EQ(run.training().episodes_done(), 1);
  EXPECT_EQ(run.database().ReadCheckpoint()->episode, 1);
  EXPECT_EQ(run.database().ReadEpisodes().back().steps, kStepsOfAnEpisode);
}

TEST_F(LiveRunTest, AStopBeforeAnEpisodeDoesNotRunIt) {
  Trainer& run = Begin(100);
  run.Run(2, "episode");
  EXPECT_EQ(run.Ask("stop")["stops"], "after episode 2");
  run.Wait();
  EXPECT_EQ(run.training().episodes_done(), 2);
}

TEST_F(LiveRunTest, SaveIsAnsweredWhenTheCheckpointIsThere) {
  Trainer& run = Begin(4);
  run.Run(5, "step");
  std::future<Reply> save = run.Send("save", json::object());
  run.Ask("status");
  EXPECT_EQ(save.wait_for(std::chrono::seconds(0)), std::future_status::timeout);
  run.Run(1, "episode");
  EXPECT_EQ(Trainer::Take(std::move(save)).value, json({{"episode", 1}}));
  EXPECT_EQ(run.database().ReadCheckpoint()->episode, 1);
  run.Ask("resume");
  run.WaitFor("finished");
  EXPECT_EQ(run.Ask("save"), json({{"episode", 4}}));  // is there already
}

TEST_F(LiveRunTest, RequestsThatStillWaitWhenItEndsAreRefused) {
  Trainer& run = Begin(100);
  std::future<Reply> save = run.Send("save", json::object());
  run.Stop();
  std::future<Reply> late = run.Send("status", json::object());
  std::future<Reply> load = run.Send("load", {{"file", PluginFile("other").string()}});
  trainer_.reset();
  for (std::future<Reply>* reply : {&save, &late, &load}) {
    EXPECT_EQ(Trainer::Take(std::move(*reply)).error, "the trainer has ended");
  }
}

TEST_F(LiveRunTest, WhatIsRefusedIsNeitherDoneNorWrittenDown) {
  Trainer& run = Begin(100);
  run.Run(1, "episode");
  EXPECT_EQ(run.Refusal("load", {{"file", PluginFile("other").string()}, {"name", "mind"}}),
            "there is a module `mind` already");
  EXPECT_EQ(run.Refusal("load", {{"file", PluginFile("other").string()}, {"name", "a.b"}}),
            "`a.b` cannot name a module: a name has no '.'");
  EXPECT_THAT(run.Refusal("load", {{"file", PluginFile("for_snake").string()}}),
              HasSubstr("is for the robot `snake`"));
  EXPECT_THAT(run.Refusal("swap", Swap("for_snake", true)), HasSubstr("is for the robot `snake`"));
  EXPECT_EQ(run.Refusal("rollback", {{"name", "task"}}),
            "`task` has no previous task: it has not been swapped yet");
  EXPECT_EQ(run.Refusal("set", {{"name", "task.gain"}}),
            "`set task.gain` needs a `value`, or `from`, `to` and `episodes` for a schedule");
  EXPECT_EQ(run.Refusal("set", {{"name", "task.gain"}, {"value", 1}, {"to", 2}}),
            "`set task.gain`: a `value` has no `to`, which is of a schedule");
  const auto schedule = [](const char* name, double to, int64_t episodes) {
    return json{{"name", name}, {"from", 1}, {"to", to}, {"episodes", episodes}};
  };
  EXPECT_EQ(run.Refusal("set", schedule("task.gain", 11, 3)),
            "`task.gain` must lie in 0 .. 10, and 11 does not");
  EXPECT_EQ(run.Refusal("set", schedule("task.gain", 2, 0)),
            "`episodes` must lie in 1 .. 1000000000, and 0 does not");
  EXPECT_EQ(run.Refusal("set", schedule("mind.mood", 2, 3)),
            "`mind.mood` is not a number, so it has no schedule");
  EXPECT_EQ(run.Refusal("set", schedule("mind.size", 2, 3)),
            "`mind.size` has no effect after the start of a run");
  EXPECT_EQ(run.Refusal("set", schedule("mind.steps", 1e300, 3)),
            "a schedule of `mind.steps` has no number as large as 1e+300");
  EXPECT_EQ(run.Refusal("graph", {{"format", "dto"}}),
            "`dto` is not a format: did you mean `dot`?");
  EXPECT_THAT(run.Changes(), IsEmpty());
  EXPECT_THAT(run.database().ReadRun().tasks, SizeIs(1));
}

TEST_F(LiveRunTest, AChangeBeforeTheFirstStepTakesEffectThere) {
  Trainer& run = Begin(100);
  EXPECT_EQ(run.Ask("swap", Swap("other", false))["takes_effect"], "now");
  EXPECT_EQ(
      run.Ask("set",
              {{"name", "task.gain"}, {"from", 2}, {"to", 4}, {"episodes", 3}})["first_episode"],
      1);
  run.Run(3, "episode");
  EXPECT_THAT(run.Changes(), ElementsAre(HasSubstr("1:0 swap swap task: other"),
                                         "1:0 set task.gain: 2 to 4 over 3 episodes"));
  std::vector<double> returns;
  for (const EpisodeRecord& episode : run.database().ReadEpisodes()) {
    EXPECT_EQ(episode.active.task, 2);
    returns.push_back(episode.active.episode_return);
  }
  using testing::DoubleNear;
  EXPECT_THAT(returns, ElementsAre(DoubleNear(0.24, 1e-12), DoubleNear(0.36, 1e-12),
                                   DoubleNear(0.48, 1e-12)));
  EXPECT_THAT(run.Ask("list")["schedules"], IsEmpty());
}

TEST_F(LiveRunTest, ATaskKeepsItsNumberHoweverOftenItIsLoaded) {
  Trainer& run = Begin(100);
  for (const char* plugin : {"other", "steady", "other"}) run.Ask("swap", Swap(plugin, true));
  EXPECT_THAT(run.record().tasks, SizeIs(2));
  run.Ask("load", {{"file", PluginFile("other").string()}, {"name", "shadow"}});
  EXPECT_THAT(run.record().tasks, SizeIs(3));  // of another module
}

TEST_F(LiveRunTest, ASwapToWhatIsThereChangesNothing) {
  Trainer& run = Begin(100);
  run.Run(5, "step");
  EXPECT_EQ(run.Ask("swap", Swap("steady", true))["takes_effect"], "already");
  EXPECT_EQ(run.Ask("swap", Swap("other", true))["takes_effect"], "now");
  EXPECT_EQ(run.Ask("swap", Swap("other", true))["takes_effect"], "already");
  EXPECT_EQ(run.Ask("swap", Swap("other", false))["takes_effect"], "already");
  EXPECT_EQ(run.Ask("rollback", {{"name", "task"}, {"now", true}})["task"], "steady");
  EXPECT_THAT(run.Changes(), ElementsAre(HasSubstr("1:5 swap"), HasSubstr("1:5 rollback")));
}

TEST_F(LiveRunTest, ASwapToWhatIsToComeChangesNothing) {
  Trainer& run = Begin(100);
  run.Run(5, "step");
  EXPECT_EQ(run.Ask("swap", Swap("other", false))["takes_effect"], "episode 2");
  EXPECT_EQ(run.Ask("swap", Swap("other", false))["takes_effect"], "already");
  EXPECT_EQ(run.Ask("swap", Swap("steady", false))["takes_effect"], "episode 2");
  EXPECT_EQ(run.Ask("swap", Swap("other", false))["takes_effect"], "episode 2");
  EXPECT_EQ(run.Ask("swap", Swap("other", true))["takes_effect"], "now");
  run.Run(2, "episode");
  const json task = run.Ask("list")["tasks"][0];
  EXPECT_EQ(task["task"], "other");
  EXPECT_EQ(task["previous"]["task"], "steady");
}

TEST_F(LiveRunTest, ListTellsWhichPhaseIsThePresentOneAndWhatEachWas) {
  Trainer& run = Begin(100);
  run.Run(6, "step");  // of 10 ms
  const json phases = run.Ask("list")["tasks"][0]["phases"];
  ASSERT_EQ(phases.size(), 2u);
  EXPECT_EQ(phases[0]["name"], "early");
  EXPECT_EQ(phases[0]["doc"], "20 ms");
  EXPECT_EQ(phases[0]["present"], false);
  EXPECT_NEAR(phases[0]["time"].get<double>(), 0.02, 1e-9);
  EXPECT_EQ(phases[1]["present"], true);
  EXPECT_NEAR(phases[1]["time"].get<double>(), 0.04, 1e-9);
  EXPECT_NEAR(phases[1]["return"].get<double>(), 0.04, 1e-9);
}

TEST_F(LiveRunTest, WhatWasLearnedCanBeForgottenWithoutAnotherTask) {
  Trainer& run = Begin(100);
  run.Run(5, "step");
  run.Ask("swap", Swap("other", true));
  json again = Swap("other", true);
  again["forget"] = true;
  EXPECT_EQ(run.Ask("swap", again)["takes_effect"], "now");
  EXPECT_EQ(run.Ask("list")["tasks"][0]["previous"]["task"], "steady");
}

TEST_F(LiveRunTest, ARollbackGoesToAnyVersion) {
  Trainer& run = Begin(100);
  run.Run(5, "step");
  for (const char* plugin : {"other", "bare"}) run.Ask("swap", Swap(plugin, true));
  const json versions = run.Ask("list")["tasks"][0]["versions"];
  ASSERT_THAT(versions, SizeIs(3));
  EXPECT_EQ(versions[0]["number"], 1);
  EXPECT_EQ(versions[0]["task"], "steady");
  const auto rollback = [](const char* version, bool now) {
    return json{{"name", "task"}, {"version", version}, {"now", now}};
  };
  EXPECT_EQ(run.Ask("rollback", rollback("1", true))["task"], "steady");
  EXPECT_EQ(run.Ask("rollback", rollback("1", true))["takes_effect"], "already");
  EXPECT_EQ(run.Ask("list")["tasks"][0]["previous"]["task"], "bare");
  EXPECT_EQ(run.Ask("rollback", rollback("2", false))["takes_effect"], "episode 2");
  EXPECT_EQ(run.Refusal("rollback", rollback("4", true)),
            "`task` has had no version `4`: it has had 1 = steady (), 2 = other (), 3 = bare ()");
  run.Run(1, "episode");
  const std::vector<std::string> changes = run.Changes();
  Trainer& again = Begin(100);  // repeats all that from its record
  EXPECT_EQ(again.Ask("list")["tasks"][0]["task"], "other");
  EXPECT_EQ(again.Changes(), changes);
}

// Every step is done by one task or the other: each pays the same.
TEST_F(LiveRunTest, TwoThousandSwapsLeaveNothingBehindAndLoseNoStep) {
  const auto open_files = [] {
    return std::distance(std::filesystem::directory_iterator("/proc/self/fd"), {});
  };
  const auto loaded_plugins = [] {
    std::ifstream maps("/proc/self/maps");
    std::set<std::string> ranges;
    for (std::string line; std::getline(maps, line);) {
      const bool is_plugin = line.find("/memfd:") != std::string::npos;
      if (is_plugin && line.find("r-xp") != std::string::npos) ranges.insert(line);
    }
    return ranges.size();
  };
  Trainer& run = Begin(1'000'000);
  run.Ask("set", {{"name", "task.gain"}, {"value", 2}});
  run.Ask("swap", Swap("other", true));
  run.Ask("swap", Swap("steady", true));
  run.Run(1, "episode");  // until nobody holds on to what was replaced
  const auto files = open_files();
  const auto plugins = loaded_plugins();
  EXPECT_EQ(plugins, 3u);  // the one that the agent began with, the active one, the previous one
  run.Ask("resume");
  size_t changes = 3;
  const auto swap = [&](const char* plugin, bool now) {
    if (run.Ask("swap", Swap(plugin, now))["takes_effect"] != "already") ++changes;
  };
  for (int i = 0; i < 1000; ++i) {
    swap("other", true);
    swap("steady", i % 10 != 0);
  }
  run.Ask("pause");
  run.Run(1, "episode");
  EXPECT_LE(open_files(), files);
  EXPECT_LE(loaded_plugins(), plugins);
  run.Stop();
  const std::vector<EpisodeRecord> episodes = run.database().ReadEpisodes();
  for (const EpisodeRecord& episode : episodes) {
    ASSERT_EQ(episode.steps, kStepsOfAnEpisode) << episode.number;
    ASSERT_NEAR(episode.active.episode_return, 0.24, 1e-12) << episode.number;
    ASSERT_EQ(episode.active.metrics[0], episode.number);  // counted by whoever was there
  }
  EXPECT_THAT(run.database().ReadChanges(), SizeIs(changes));
  EXPECT_GT(changes, 1900u);  // the others found what they wanted, with another one to come
  EXPECT_THAT(run.record().tasks, SizeIs(2));
}

TEST_F(LiveRunTest, ChangesOfAFinishedRunBelongToTheNextEpisode) {
  Trainer& run = Begin(2);
  run.Run(1, "episode");
  run.Run(3, "step");
  EXPECT_EQ(run.Ask("swap", Swap("other", false))["takes_effect"], "episode 3");
  run.Ask("resume");
  run.WaitFor("finished");
  EXPECT_EQ(
      run.Ask("load", {{"file", PluginFile("other").string()}, {"name", "shadow"}})["takes_effect"],
      "episode 3");
  run.Ask("set", {{"name", "task.gain"}, {"value", 3}});
  EXPECT_THAT(run.Changes(),
              ElementsAre(HasSubstr("3:0 swap"), HasSubstr("3:0 load"), HasSubstr("3:0 set")));
  run.Ask("resume", {{"episodes", 3}});
  run.WaitFor("finished");
  EXPECT_THAT(run.events.Of("change", "id"), ElementsAre(1, 2, 3));
  const EpisodeRecord last = run.database().ReadEpisodes().back();
  EXPECT_EQ(last.active.task, 2);
  EXPECT_NEAR(last.active.episode_return, 0.36, 1e-12);
  EXPECT_THAT(last.shadows, SizeIs(1));
  run.Ask("unload", {{"name", "shadow"}});  // known to the training, too
  run.Ask("resume", {{"episodes", 4}});
  run.WaitFor("finished");
  EXPECT_THAT(run.database().ReadEpisodes().back().shadows, IsEmpty());
}

TEST_F(LiveRunTest, WhatWasChangedBeforeAStopIsRepeatedOnce) {
  Begin(2).Ask("resume");
  trainer_->WaitFor("finished");
  trainer_->Ask("load", {{"file", PluginFile("other").string()}, {"name", "shadow"}});
  trainer_->Send("resume", {{"episodes", 5}});
  trainer_->Stop();
  Trainer& run = Begin(6);  // the stop may have come when five were done
  EXPECT_EQ(run.Ask("list")["tasks"].size(), 2u);
  run.Ask("resume");
  run.WaitFor("finished");
  EXPECT_THAT(run.database().ReadEpisodes(), SizeIs(6));
}

// That a schedule has ended, and when, depends on what was changed meanwhile.
TEST_F(LiveRunTest, AScheduleIsRepeatedAsItWas) {
  Trainer& first = Begin(100);
  first.Ask("set", {{"name", "mind.pace"}, {"from", 1}, {"to", 3}, {"episodes", 5}});
  first.Ask("set", {{"name", "task.gain"}, {"from", 1}, {"to", 9}, {"episodes", 50}});
  first.Run(2, "episode");
  first.Ask("swap", Swap("bare", true));  // has no `gain`: this schedule ends
  first.Run(1, "step");
  first.Ask("swap", Swap("steady", true));
  first.Run(4, "episode");
  EXPECT_THAT(first.Ask("list")["schedules"], IsEmpty());
  EXPECT_EQ(first.Ask("get", {{"name", "mind.pace"}})["value"], 3);
  Trainer& second = Begin(100);
  EXPECT_THAT(second.Ask("list")["schedules"], IsEmpty());
  EXPECT_EQ(second.Ask("get", {{"name", "mind.pace"}})["value"], 3);
  EXPECT_EQ(second.Ask("get", {{"name", "task.gain"}})["value"], 1);
}

TEST_F(LiveRunTest, TheRunGoesOnWithoutAChangeThatIsBlamed) {
  Trainer& first = Begin(100);
  EXPECT_FALSE(first.live().BlameLastChange("before any change"));
  first.Run(1, "step");
  first.Ask("set", {{"name", "task.gain"}, {"value", 2}});
  first.Ask("module_add", {{"type", "Reader"}, {"name", "reader"}});
  first.Ask("load", {{"file", PluginFile("other").string()}, {"name", "shadow"}});
  first.Ask("unload", {{"name", "shadow"}});
  first.Stop();                                            // with a checkpoint that knows `reader`
  EXPECT_TRUE(first.live().BlameLastChange("no reason"));  // the `load`
  EXPECT_EQ(first.Changes().back(),
            "1:11 quarantine taken back: load shadow: other () (no reason)");
  Trainer& second = Begin(3);
  second.Ask("resume");
  second.WaitFor("finished");
  EXPECT_THAT(second.database().ReadEpisodes(), SizeIs(3));
}

}  // namespace
}  // namespace runtime
