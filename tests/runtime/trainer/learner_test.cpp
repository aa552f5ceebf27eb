// That a learner is whatever module implements runtime/training/learning/learner.h: one of which
// neither the program nor its agents know is trained by what the program's commands call.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>

#include <chrono>
#include <functional>
#include <future>
#include <thread>

#include "runtime/live/client/client.h"
#include "runtime/trainer/results/evaluate_run.h"
#include "runtime/trainer/runs/one_run.h"
#include "tests/runtime/trainer/random_targets.h"
#include "tests/runtime/training/run/temporary_folder.h"
#include "tests/scoped_environment.h"

namespace runtime {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::Ne;
using testing::SizeIs;

ModuleTypes TypesWithRandomTargets() {
  ModuleTypes types = ProgramModuleTypes();
  types.Add<RandomTargets>("RandomTargets");
  types.Add<HeldTargets>("HeldTargets");
  return types;
}

std::string PluginFile(const std::string& task) {
  return std::string(PLUGIN_FOLDER) + "/" + task + ".so";
}

class LearnerTest : public testing::Test {
 protected:
  std::filesystem::path Run(const std::string& name) const { return folder_.path() / name; }

  int Train(const std::string& name, int64_t episodes) const {
    const TaskOptions task{.task = PluginFile("leaning"),
                           .profile = "fast",
                           .agent = AGENT,
                           .robot = "humanoid",
                           .settings = {"policy.pace=0.005"}};
    const RunPlan plan{.episodes = episodes, .seed = 5, .record_every = 1, .checkpoint_seconds = 0};
    return TrainOneRun(task, plan, Run(name), Session(), types_);
  }
  int Resume(const std::string& name, int64_t episodes,
             LiveRun::WhenDone when_done = LiveRun::WhenDone::kEnd) const {
    return ResumeOneRun(Run(name), episodes, Session(when_done), types_);
  }
  PolicyEvaluation Evaluate(const std::string& name, int64_t episodes) const {
    const StopRequest stop;
    return EvaluateRun(Run(name), {.profile = "fast", .episodes = episodes}, ProgressStyle::kQuiet,
                       stop, types_)
        .value();
  }

  // All that must be the same, bit for bit, however often the run was interrupted.
  std::vector<std::string> TraceOf(const std::string& name) const {
    const RunDatabase database = RunDatabase::OpenToRead(Run(name));
    std::vector<std::string> trace;
    for (const EpisodeRecord& episode : database.ReadEpisodes()) {
      std::vector<double> shown;
      for (const NamedValue& each : episode.learner) shown.push_back(each.value);
      trace.push_back(
          fmt::format("{} task {} return {:a} steps {} actions {} reach {::a} terms {::a}",
                      episode.number, episode.active.task, episode.active.episode_return,
                      episode.steps, episode.actions, shown, episode.active.terms));
      trace.push_back(database.ReadRecording(episode.number).value().poses);
    }
    trace.push_back(database.ReadCheckpoint().value().state);
    return trace;
  }
  std::vector<EpisodeRecord> EpisodesOf(const std::string& name) const {
    return RunDatabase::OpenToRead(Run(name)).ReadEpisodes();
  }
  std::vector<double> ReturnsOf(const std::string& name) const {
    std::vector<double> returns;
    for (const EpisodeRecord& episode : EpisodesOf(name)) {
      returns.push_back(episode.active.episode_return);
    }
    return returns;
  }

 private:
  static SessionOptions Session(LiveRun::WhenDone when_done = LiveRun::WhenDone::kEnd) {
    return {.output = {.json = false, .quiet = true}, .when_done = when_done};
  }

  const ScopedEnvironment robots_{"TASKC_ROBOT_PATH", ROBOTS};
  const ModuleTypes types_ = TypesWithRandomTargets();
  TemporaryFolder folder_;
};

double ReachIn(const EpisodeRecord& episode) { return episode.learner.at(0).value; }

TEST_F(LearnerTest, IsTrainedAndShowsItself) {
  ASSERT_EQ(Train("run", 5), 0);
  const RunDatabase database = RunDatabase::OpenToRead(Run("run"));
  EXPECT_EQ(database.ReadRun().profile, "fast");
  const std::vector<CurveRecord> curves = database.ReadLearnerCurves();
  ASSERT_THAT(curves, SizeIs(1));
  EXPECT_EQ(curves[0].name, "reach");
  EXPECT_EQ(curves[0].unit, "rad");
  const std::vector<EpisodeRecord> episodes = EpisodesOf("run");
  ASSERT_THAT(episodes, SizeIs(5));
  for (const EpisodeRecord& episode : episodes) {
    EXPECT_GT(episode.actions, 2);
    EXPECT_EQ(episode.actions, (episode.steps + 7) / 8);  // of 8 time steps, but for the last
    ASSERT_THAT(episode.learner, SizeIs(1));
    EXPECT_EQ(episode.learner[0].name, "reach");
  }
  EXPECT_NE(ReachIn(episodes[0]), RandomTargets::kFirstReach);
  EXPECT_NE(ReachIn(episodes[1]), ReachIn(episodes[0]));
  EXPECT_NE(ReturnsOf("run")[1], ReturnsOf("run")[0]);
}

TEST_F(LearnerTest, GoesOnBitForBit) {
  ASSERT_EQ(Train("whole", 6), 0);
  ASSERT_EQ(Train("parts", 2), 0);
  ASSERT_EQ(Resume("parts", 3), 0);
  ASSERT_EQ(Resume("parts", 6), 0);
  EXPECT_TRUE(TraceOf("parts") == TraceOf("whole"));
}

// A run that waits for what comes next, in a thread of its own.
class ServedRun {
 public:
  ServedRun(std::filesystem::path folder, std::function<int()> train)
      : folder_(std::move(folder)), training_(std::async(std::launch::async, std::move(train))) {
    while (!HasTrainer(folder_) && !HasEnded()) Wait();
    WaitUntilDone();
  }
  ~ServedRun() {
    if (!HasEnded()) Request("stop", json::object());
  }

  json Request(const std::string& command, json arguments) const {
    const Reply reply = Ask(folder_, {command, std::move(arguments)});
    EXPECT_TRUE(reply.ok) << command << ": " << reply.error;
    return reply.value;
  }
  void WaitUntilDone() const {
    while (Request("status", json::object())["state"] != "finished") Wait();
  }

 private:
  bool HasEnded() const {
    return training_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  }
  static void Wait() { std::this_thread::sleep_for(std::chrono::milliseconds(5)); }

  std::filesystem::path folder_;
  std::future<int> training_;
};

TEST_F(LearnerTest, KeepsWhatItLearnedWhenTheTaskIsSwappedUnlessItIsToldToForget) {
  ASSERT_EQ(Train("run", 2), 0);
  {
    const ServedRun run(Run("run"), [&] { return Resume("run", 3, LiveRun::WhenDone::kWait); });
    const json swap = {{"name", "task"}, {"file", PluginFile("upright")}};
    EXPECT_EQ(run.Request("swap", swap)["task"], "upright");
    run.Request("resume", {{"episodes", 4}});
    run.WaitUntilDone();
    json forget = {{"name", "task"}, {"file", PluginFile("leaning")}, {"forget", true}};
    run.Request("swap", forget);
    run.Request("set", {{"name", "policy.pace"}, {"value", 0}});
    run.Request("resume", {{"episodes", 5}});
    run.WaitUntilDone();
  }
  const std::vector<EpisodeRecord> episodes = EpisodesOf("run");
  ASSERT_THAT(episodes, SizeIs(5));
  EXPECT_EQ(episodes[2].active.task, 1);
  EXPECT_EQ(episodes[3].active.task, 2);
  EXPECT_NE(ReachIn(episodes[2]), RandomTargets::kFirstReach);
  EXPECT_NE(ReachIn(episodes[3]), RandomTargets::kFirstReach);
  EXPECT_EQ(ReachIn(episodes[4]), RandomTargets::kFirstReach);
  // All of that is part of the run.
  ASSERT_EQ(Resume("run", 6), 0);
  EXPECT_EQ(ReachIn(EpisodesOf("run").back()), RandomTargets::kFirstReach);
}

TEST_F(LearnerTest, IsEvaluatedWithoutLearning) {
  ASSERT_EQ(Train("run", 4), 0);
  const PolicyEvaluation evaluation = Evaluate("run", 4);
  EXPECT_EQ(Evaluate("run", 4).returns, evaluation.returns);
  EXPECT_EQ(evaluation.checkpoint_episode, 4);
  ASSERT_EQ(Resume("run", 8), 0);
  const std::vector<double> returns = ReturnsOf("run");
  const std::vector<double> learned(returns.begin() + 4, returns.end());
  EXPECT_THAT(evaluation.returns, Ne(learned));  // the run learns on
}

}  // namespace
}  // namespace runtime
