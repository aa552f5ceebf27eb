#include "tests/runtime/trainer/live_test.h"

#include <fstream>

#include "runtime/training/run/run_files.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

// In a process of its own, so that a task that crashes takes nothing with it; the run learns on as
// if nothing had been asked.
TEST_F(LiveTest, ARecordedEpisodeIsJudgedByAnotherTask) {
  Serve(100);
  RunEpisodes(1);
  const json judged = Ask({"rescore", TaskFile("upright")});
  EXPECT_EQ(judged["recorded"].front(), 1);
  const auto number = judged["episode"].get<size_t>();
  EXPECT_EQ(judged["episode"], judged["recorded"].back());
  EXPECT_EQ(judged["recorded_return"], Episodes().at(number - 1).active.episode_return);
  EXPECT_NE(judged["old"]["terms"], judged["new"]["terms"]);
  EXPECT_THAT(Refusal({"rescore", TaskFile("upright"), "--episode", "77"}),
              testing::HasSubstr("episode 77 is not recorded"));
  EXPECT_THAT(Refusal({"rescore", Plugin("crashes")}), testing::HasSubstr("cannot be judged"));
  EXPECT_EQ(Ask({"list"})["tasks"].size(), 1u);
  EXPECT_EQ(Changes().size(), 0u);
}

TEST_F(LiveTest, WhatWasChangedIsEvaluatedAsItWas) {
  Serve(100,
        {"--set", "learner.episode_end=immediate"});  // at the limit, not when an action is over
  Ask({"set", "task.limit", "0.1", "s"});
  RunEpisodes(2);
  EXPECT_EQ(Stop().exit_status, 0);
  const ProgramResult result =
      Trainer({"evaluate", RunFolder("run"), "--profile", "fast", "--episodes", "1", "--json"});
  const json episode = json::parse(result.output.substr(0, result.output.find('\n')));
  EXPECT_EQ(episode["steps"], Episodes().back().steps);
  EXPECT_LT(episode["steps"], Episodes().front().steps);
}

// As an editor does whose text is not saved.
TEST_F(LiveTest, ATextIsBuiltInThePlaceOfAFile) {
  Serve(100);
  const std::string file = (folder() / "edited.task").string();  // is not there
  const json swap = Ask({"swap", "task", file, "--text", ReadText(TaskFile("upright")), "--now"});
  EXPECT_EQ(swap["task"], "upright");
  EXPECT_THAT(Refusal({"swap", "task", file, "--text", "task"}), HasSubstr("edited.task:1:"));
  EXPECT_THAT(Refusal({"swap", "task", (folder() / "a.so").string(), "--text", "task"}),
              HasSubstr("a text is that of a .task file"));
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST_F(LiveTest, ASwapTakesEffectWhenTheNextEpisodeStarts) {
  Serve(100);
  RunSteps(5);
  const json status = Ask({"status"});
  const int64_t episode = status["episode"];
  EXPECT_EQ(status["step"], 5);
  const json swap = Ask({"swap", "task", TaskFile("upright")});
  EXPECT_EQ(swap["task"], "upright");
  EXPECT_EQ(swap["takes_effect"], "episode " + std::to_string(episode + 1));
  EXPECT_EQ(TaskNamed("task")["task"], "leaning");
  RunEpisodes(2);
  EXPECT_EQ(TaskNamed("task")["task"], "upright");
  EXPECT_EQ(TaskNamed("task")["previous"]["task"], "leaning");
  EXPECT_EQ(Stop().exit_status, 0);
  const std::vector<EpisodeRecord> episodes = Episodes();
  EXPECT_EQ(episodes[episode - 1].active.task, 1);
  EXPECT_EQ(episodes[episode].active.task, 2);
  ASSERT_THAT(episodes[episode].active.terms, SizeIs(2));
  // `count` pays as many per second as episodes have begun, for the whole of this one.
  EXPECT_NEAR(episodes[episode].active.terms[1],
              static_cast<double>(episode + 1) * episodes[episode].simulated_seconds, 1e-9);
  EXPECT_THAT(Changes(), ElementsAre(std::to_string(episode + 1) + ":0 swap"));
}

TEST_F(LiveTest, ASwapNowKeepsWhatBothTasksRemember) {
  Serve(100);
  Ask({"set", "task.limit", "0.4 s"});
  RunSteps(5);
  EXPECT_EQ(Ask({"swap", "task", TaskFile("upright"), "--now"})["takes_effect"], "now");
  const json task = TaskNamed("task");
  EXPECT_EQ(task["params"][0]["value"], 0.4);
  EXPECT_EQ(task["params"][0]["unit"], "s");
  RunSteps(1);
  // `episodes` goes on: it pays as many per second as episodes have begun.
  const double count = TaskNamed("task")["terms"]["count"];
  EXPECT_NEAR(count, 0.005 * Ask({"status"})["episode"].get<double>(), 1e-9);
  EXPECT_EQ(Ask({"rollback", "task", "--now"})["task"], "leaning");
  EXPECT_EQ(TaskNamed("task")["previous"]["task"], "upright");
  EXPECT_EQ(Stop().exit_status, 0);
}

TEST_F(LiveTest, WhatIsWrongChangesNothing) {
  Serve(100);
  std::ofstream(folder() / "wrong.task") << "task wrong for humanoid\non end_of_time_step {\n"
                                            "  reward x = base.velocty.x\n}\n";
  std::ofstream(folder() / "half.so") << "\x7f"
                                         "ELF";
  EXPECT_THAT(Refusal({"swap", "task", (folder() / "wrong.task").string()}),
              AllOf(HasSubstr("wrong.task:3:"), HasSubstr("base.velocity")));
  EXPECT_THAT(Refusal({"swap", "task", (folder() / "half.so").string()}),
              HasSubstr("build the task with `taskc build`"));
  EXPECT_THAT(Refusal({"swap", "task", (folder() / "none.task").string()}),
              HasSubstr("there is no such file"));
  EXPECT_THAT(Refusal({"swap", "tusk", TaskFile("upright")}),
              HasSubstr("there is no task module `tusk`: did you mean `task`?"));
  EXPECT_THAT(Refusal({"rollback", "task"}), HasSubstr("no previous task"));
  EXPECT_THAT(Refusal({"unload", "task"}), HasSubstr("is the active task"));
  EXPECT_THAT(Refusal({"promote", "task"}), HasSubstr("active already"));
  EXPECT_THAT(Refusal({"load", TaskFile("upright"), "as", "learner"}),
              HasSubstr("there is a module `learner` already"));
  EXPECT_THAT(Refusal({"set", "task.limit", "11 s"}), HasSubstr("must lie in 0 .. 10"));
  EXPECT_THAT(Refusal({"set", "task.limit", "1 m"}), HasSubstr("is a number in s"));
  EXPECT_THAT(Refusal({"set", "task.limt", "1"}), HasSubstr("did you mean `limit`?"));
  EXPECT_THAT(Refusal({"set", "features.net", "bq01"}), HasSubstr("has no effect any more"));
  EXPECT_THAT(Refusal({"set", "task.limit", "=", "1", "->", "20", "over", "3", "episodes"}),
              HasSubstr("must lie in 0 .. 10, and 20 does not"));
  EXPECT_THAT(Refusal({"connect", "task.reward", "learner.end_of_action"}),
              HasSubstr("`task.reward` fits `learner.reward`"));
  EXPECT_THAT(Refusal({"disconnect", "task.reward", "learner.reward"}),
              HasSubstr("no task pays the learner"));
  EXPECT_THAT(Refusal({"disconnect", "features.features", "learner.features"}),
              HasSubstr("must have a value"));
  EXPECT_THAT(Refusal({"module", "remove", "learner"}), HasSubstr("cannot do without"));
  EXPECT_THAT(Refusal({"module", "remove", "features"}), HasSubstr("is read by"));
  EXPECT_THAT(Refusal({"module", "add", "NgNett", "net"}), HasSubstr("did you mean `NgNet`?"));
  EXPECT_THAT(Changes(), IsEmpty());
  EXPECT_EQ(Stop().exit_status, 0);
}

// The trainer was told of the file by another path than `watch` tells it.
TEST_F(LiveTest, WatchSwapsOnlyWhatIsAnother) {
  const std::filesystem::path file = folder() / "mine.task";
  std::filesystem::copy_file(TaskFile("leaning"), file);
  Serve(100, {}, (folder() / "." / "mine.task").string());
  ChildProcess watch(
      {TRAINER, "ctl", "watch", file.string(), "--forget", "--json", "--run", RunFolder("run")});
  ASSERT_TRUE(watch.WaitForLines(1));
  int lines = 1;
  const auto save = [&](const std::string& text) {
    std::ofstream(file) << text;
    EXPECT_TRUE(watch.WaitForLines(++lines));
  };
  const std::string second = ReadText(TaskFile("upright"));
  save(ReadText(TaskFile("leaning")));
  EXPECT_THAT(Changes(), IsEmpty());
  save(second);
  EXPECT_THAT(Changes(), SizeIs(2));  // to swap, then to forget
  save("task broken extends");
  save(second);
  EXPECT_THAT(Changes(), SizeIs(2));
  EXPECT_EQ(Ask({"rollback", "task"})["task"], "leaning");
  EXPECT_EQ(Ask({"rollback", "task", "2"})["task"], "upright");
  EXPECT_EQ(Stop().exit_status, 0);
}

TEST_F(LiveTest, WatchTellsThatItsTaskIsAShadowAndThatTheTrainerHasEnded) {
  const std::filesystem::path file = folder() / "mine.task";
  std::filesystem::copy_file(TaskFile("leaning"), file);
  Serve(100);
  Ask({"load", TaskFile("upright"), "as", "other"});
  Ask({"promote", "other"});
  ChildProcess watch({TRAINER, "ctl", "watch", file.string(), "--run", RunFolder("run")});
  ASSERT_TRUE(watch.WaitForLines(1));
  std::ofstream(file, std::ios::app) << "\n";
  ASSERT_TRUE(watch.WaitForLines(2));
  std::ofstream(file, std::ios::app);
  ASSERT_TRUE(watch.WaitForLines(3));
  Stop();
  const ProgramResult result = watch.Wait();
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, HasSubstr("the trainer has ended"));
  EXPECT_THAT(result.output,
              AllOf(HasSubstr("mine.task takes effect: now, as a shadow: another task pays "
                              "the learner until `task` is promoted ("),
                    HasSubstr("mine.task is there already: nothing to swap, as a shadow: ")));
}

TEST_F(LiveTest, WatchOutlivesACrashOfTheTrainer) {
  const std::filesystem::path file = folder() / "mine.task";
  std::filesystem::copy_file(TaskFile("leaning"), file);
  Serve(100, {"--checkpoint-every", "0"});
  ChildProcess watch({TRAINER, "ctl", "watch", file.string(), "--run", RunFolder("run")});
  ASSERT_TRUE(watch.WaitForLines(1));
  Ask({"swap", "task", Plugin("crashes"), "--now"});
  Ctl({"resume"});
  ASSERT_TRUE(trainer_->WaitForError("`crashes` has failed"));
  WaitForState("running");
  std::ofstream(file, std::ios::app) << "// another\n";
  EXPECT_TRUE(watch.WaitForLines(2));
  Stop();
  EXPECT_THAT(watch.Wait().output, HasSubstr("mine.task takes effect: "));
}

TEST_F(LiveTest, AShadowIsEvaluatedOnTheSameSteps) {
  Serve(100);
  Ask({"load", TaskFile("leaning"), "as", "twin"});
  Ask({"load", TaskFile("upright")});
  RunEpisodes(3);
  EXPECT_EQ(TaskNamed("twin")["role"], "shadow");
  EXPECT_EQ(Stop().exit_status, 0);
  const EpisodeRecord episode = Episodes().back();
  ASSERT_THAT(episode.shadows, SizeIs(2));
  const Evaluation& twin = episode.shadows[0];
  EXPECT_EQ(twin.terms[0], episode.active.terms[0]);  // the other one counts episodes
  EXPECT_EQ(twin.metrics, episode.active.metrics);
  EXPECT_EQ(twin.logs, episode.active.logs);
  EXPECT_EQ(twin.end_reason, episode.active.end_reason);
  EXPECT_NEAR(twin.episode_return, twin.terms[0] + twin.terms[1], 1e-12);
  EXPECT_EQ(episode.shadows[1].end_reason, "time is up");
}

TEST_F(LiveTest, ShadowsHaveNoInfluence) {
  Serve(100);
  const int64_t before = Ask({"status"})["episodes_done"];
  Ask({"load", TaskFile("upright")});
  Ask({"load", TaskFile("leaning"), "as", "twin"});
  RunEpisodes(5);
  EXPECT_EQ(Stop().exit_status, 0);
  Train("plain", static_cast<int>(before) + 5, {"--quiet"});
  EXPECT_EQ(TraceOf("run").episodes, TraceOf("plain").episodes);
}

TEST_F(LiveTest, APromotedShadowPaysTheLearner) {
  Serve(100);
  Ask({"load", TaskFile("upright"), "as", "other"});
  RunEpisodes(1);
  Ask({"promote", "other"});
  EXPECT_EQ(TaskNamed("other")["role"], "active");
  EXPECT_EQ(TaskNamed("task")["role"], "shadow");
  RunEpisodes(1);
  EXPECT_EQ(Ask({"status"})["task"], "upright");
  Ask({"unload", "task"});
  RunEpisodes(1);
  EXPECT_EQ(Stop().exit_status, 0);
  const std::vector<EpisodeRecord> episodes = Episodes();
  const EpisodeRecord& last = episodes.back();
  EXPECT_EQ(last.active.task, 2);
  EXPECT_THAT(last.shadows, IsEmpty());
  EXPECT_NEAR(last.active.episode_return, last.active.terms[0] + last.active.terms[1], 1e-12);
  EXPECT_EQ(episodes[episodes.size() - 2].shadows[0].task, 1);
}

TEST_F(LiveTest, ParametersFollowASchedule) {
  Serve(100);
  Ask({"set", "task.limit", "=", "0.1", "->", "0.3", "over", "3", "episodes"});
  RunEpisodes(5);
  EXPECT_THAT(Ask({"list"})["schedules"], IsEmpty());
  EXPECT_EQ(Ask({"get", "task.limit"})["value"], 0.3);
  EXPECT_EQ(Stop().exit_status, 0);
  std::vector<double> lengths;
  for (const EpisodeRecord& episode : Episodes()) lengths.push_back(episode.simulated_seconds);
  lengths.erase(lengths.begin(), lengths.end() - 5);
  // An episode ends with the action in which the limit is reached.
  for (const auto& [length, limit] :
       {std::pair{lengths[0], 0.1}, {lengths[1], 0.2}, {lengths[2], 0.3}, {lengths[4], 0.3}}) {
    EXPECT_GE(length, limit);
  }
  EXPECT_LT(lengths[0], 0.29);
}

// A run that is changed in all ways, and then made again from nothing but its record.
TEST_F(LiveTest, WhatWasDoneLiveIsRepeatedBitForBit) {
  Serve(100, {"--checkpoint-every", "0"});
  RunSteps(7);
  Ask({"set", "learner.temperature", "2"});
  Ask({"swap", "task", TaskFile("upright"), "--now"});
  RunSteps(11);
  Ask({"set", "task.gain", "3"});
  Ask({"load", TaskFile("leaning"), "as", "shadow"});
  RunEpisodes(2);
  RunSteps(3);
  Ask({"promote", "shadow", "--now"});
  EXPECT_THAT(Refusal({"promote", "shadow"}), HasSubstr("active already"));
  Ask({"set", "learner.temperature", "=", "1", "->", "0.5", "over", "6", "episodes"});
  RunEpisodes(2);
  Ask({"rollback", "task"});
  Ask({"swap", "shadow", TaskFile("upright"), "--forget"});
  Ask({"disconnect", "environment.start_of_physics_step", "task.on_start_of_physics_step"});
  RunEpisodes(3);
  Ask({"unload", "task"});
  RunSteps(2);
  Kill();
  const std::vector<std::string> changes = Changes();
  EXPECT_THAT(changes, SizeIs(10));
  ExpectTheSameFromTheRecord(20);
  EXPECT_THAT(Episodes(), SizeIs(20));
  EXPECT_EQ(Changes(), changes);
}

TEST_F(LiveTest, AServingTrainerWaitsForMoreEpisodes) {
  Serve(4);
  Ask({"resume"});
  WaitForState("finished");
  EXPECT_THAT(Refusal({"resume"}), HasSubstr("all 4 planned episodes are done"));
  EXPECT_EQ(Ask({"resume", "--episodes", "6"})["state"], "running");
  WaitForState("finished");
  EXPECT_THAT(Episodes(), SizeIs(6));
  EXPECT_EQ(Stop().exit_status, 0);
  EXPECT_EQ(RunDatabase::OpenToRead(RunFolder("run")).ReadState(), RunState::kFinished);
}

TEST_F(LiveTest, SaveWritesACheckpointAfterTheEpisode) {
  Serve(1000, {"--checkpoint-every", "1000"});
  Ask({"resume"});
  const int64_t episode = Ask({"save"})["episode"];
  EXPECT_EQ(RunDatabase::OpenToRead(RunFolder("run")).ReadCheckpoint()->episode, episode);
  EXPECT_EQ(Stop().exit_status, 0);
}

TEST_F(LiveTest, ATaskThatCrashesIsTakenOutOfTheRun) {
  Serve(100, {"--checkpoint-every", "0"});
  Ask({"swap", "task", Plugin("crashes"), "--now"});
  Ctl({"resume"});  // may have no time to answer
  ASSERT_TRUE(trainer_->WaitForError("`crashes` has failed (crash: Segmentation fault)"));
  WaitForState("running");
  EXPECT_EQ(TaskNamed("task")["task"], "leaning");
  EXPECT_THAT(Refusal({"swap", "task", Plugin("crashes")}), HasSubstr("has crashed in this run"));
  EXPECT_EQ(Stop().exit_status, 0);
  EXPECT_THAT(Changes(), Contains(HasSubstr("quarantine")));
}

TEST_F(LiveTest, AShadowThatDoesNotComeBackIsTakenOutOfTheRun) {
  Serve(100, {"--checkpoint-every", "0"});
  Ask({"load", Plugin("loops")});
  Ctl({"resume"});
  ASSERT_TRUE(trainer_->WaitForError("`loops` has failed (it did not return"));
  WaitForState("running");
  EXPECT_THAT(Ask({"list"})["tasks"], SizeIs(1));
  EXPECT_EQ(Stop().exit_status, 0);
}

TEST_F(LiveTest, APluginThatCrashesWhileItIsLoadedDoesNoHarm) {
  Serve(100, {"--checkpoint-every", "0"});
  Ask({"resume"});
  Ctl({"load", Plugin("crashes_on_load")});
  ASSERT_TRUE(trainer_->WaitForError("a task could not be loaded"));
  WaitForState("running");
  EXPECT_EQ(Stop().exit_status, 0);
}

TEST_F(LiveTest, AConnectionThatCannotWorkIsTakenBack) {
  Serve(100, {"--checkpoint-every", "0"});
  Ask({"connect", "features.features", "environment.joint_targets"});
  Ctl({"resume"});
  ASSERT_TRUE(trainer_->WaitForError("the last change is undone"));
  WaitForState("running");
  EXPECT_EQ(Stop().exit_status, 0);
  EXPECT_THAT(Changes(), Contains(HasSubstr("quarantine")));
}

TEST_F(LiveTest, AConnectionThatCallsItselfIsTakenBack) {
  Serve(100, {"--checkpoint-every", "0"});
  Ask({"connect", "task.reward", "task.on_end_of_time_step"});
  Ctl({"resume"});
  ASSERT_TRUE(trainer_->WaitForError("the last change is undone"));
  WaitForState("running");
  EXPECT_EQ(Stop().exit_status, 0);
  EXPECT_THAT(Changes(), Contains(HasSubstr("quarantine")));
}

TEST_F(LiveTest, ModulesComeAndGo) {
  Serve(100);
  Ask({"module", "add", "NgNet", "net"});
  EXPECT_THAT(Ask({"list"})["modules"].dump(), HasSubstr(R"({"name":"net","started":false})"));
  EXPECT_THAT(Refusal({"connect", "net.features", "learner.features"}),
              HasSubstr("is not started yet"));
  Ask({"connect", "state.state", "net.state"});
  EXPECT_THAT(Ask({"list"})["modules"].dump(), HasSubstr(R"({"name":"net","started":true})"));
  Ask({"connect", "net.features", "learner.features"});
  RunEpisodes(2);
  EXPECT_THAT(Refusal({"module", "remove", "net"}), HasSubstr("is read by"));
  Ask({"connect", "features.features", "learner.features"});
  Ask({"module", "remove", "net"});
  const int64_t done = Ask({"status"})["episodes_done"];
  EXPECT_EQ(Stop().exit_status, 0);
  Train("plain", static_cast<int>(done), {"--quiet"});  // another net of the same seed: equal
  EXPECT_EQ(TraceOf("run").episodes, TraceOf("plain").episodes);
}

TEST_F(LiveTest, TrainAndResumeAnswerToo) {
  trainer_.emplace([&] {
    std::vector<std::string> words = Training("run", 100'000, {"--json"});
    words.insert(words.begin(), TRAINER);
    return words;
  }());
  ASSERT_TRUE(trainer_->WaitForLines(1));
  EXPECT_EQ(Ask({"status"})["state"], "running");
  EXPECT_EQ(Stop().exit_status, 0);
  EXPECT_FALSE(std::filesystem::exists(folder() / "run" / "control.sock"));
}

}  // namespace
}  // namespace runtime
