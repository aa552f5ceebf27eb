// Runs of learners by what the program's commands call.
#pragma once

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
#include "tests/runtime/trainer/held_targets.h"
#include "tests/runtime/training/run/temporary_folder.h"
#include "tests/scoped_environment.h"

namespace runtime {

inline std::string PluginFile(const std::string& task) {
  return std::string(PLUGIN_FOLDER) + "/" + task + ".so";
}

class LearnerRunTest : public testing::Test {
 protected:
  // `task`: what runs are made of. Besides the program's modules there are HeldTargets.
  explicit LearnerRunTest(TaskOptions task) : task_(std::move(task)) {
    types_.Add<HeldTargets>("HeldTargets");
  }

  ModuleTypes& types() { return types_; }
  TaskOptions& task() { return task_; }
  // How many episodes runs have at a time from now on; at first one.
  void UseJobs(int jobs) { jobs_ = jobs; }
  std::filesystem::path Run(const std::string& name) const { return folder_.path() / name; }

  int Train(const std::string& name, int64_t episodes) const {
    const RunPlan plan{.episodes = episodes, .seed = 5, .record_every = 1, .checkpoint_seconds = 0};
    return TrainOneRun(task_, plan, Run(name), Session(), types_);
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
  SessionOptions Session(LiveRun::WhenDone when_done = LiveRun::WhenDone::kEnd) const {
    return {.output = {.json = false, .quiet = true}, .when_done = when_done, .jobs = jobs_};
  }

  const ScopedEnvironment robots_{"TASKC_ROBOT_PATH", ROBOTS};
  TaskOptions task_;
  int jobs_ = 1;
  ModuleTypes types_ = ProgramModuleTypes();
  TemporaryFolder folder_;
};

// A run that waits for what comes next, in a thread of its own.
class ServedRun {
 public:
  ServedRun(std::filesystem::path folder, std::function<int()> train)
      : folder_(std::move(folder)), training_(std::async(std::launch::async, std::move(train))) {
    while (!HasTrainer(folder_) && !HasEnded()) Wait();
    WaitUntilDone();
  }
  ~ServedRun() {
    if (!HasEnded()) Request("stop", nlohmann::json::object());
  }

  nlohmann::json Request(const std::string& command, nlohmann::json arguments) const {
    const Reply reply = Ask(folder_, {command, std::move(arguments)});
    EXPECT_TRUE(reply.ok) << command << ": " << reply.error;
    return reply.value;
  }
  // Why the command is refused.
  std::string Refusal(const std::string& command, nlohmann::json arguments) const {
    const Reply reply = Ask(folder_, {command, std::move(arguments)});
    EXPECT_FALSE(reply.ok) << command << ": " << reply.value.dump();
    return reply.error;
  }
  void WaitUntilDone() const {
    while (Request("status", nlohmann::json::object())["state"] != "finished") Wait();
  }

 private:
  bool HasEnded() const {
    return training_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  }
  static void Wait() { std::this_thread::sleep_for(std::chrono::milliseconds(5)); }

  std::filesystem::path folder_;
  std::future<int> training_;
};

}  // namespace runtime
