// What the tests of a LiveRun share: a run that is talked to while it learns nothing worth knowing.
#pragma once

#include <gmock/gmock.h>
#include <stdio.h>

#include <chrono>
#include <filesystem>
#include <future>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "runtime/live/control/live_run.h"
#include "runtime/training/run/progress.h"
#include "runtime/training/run/run_files.h"
#include "runtime/training/run/sqlite.h"
#include "runtime/training/run/task_record.h"
#include "runtime/training/run/training.h"
#include "tests/runtime/live/control/small_agent.h"
#include "tests/runtime/training/run/sample_run.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {

using nlohmann::json;
using WhenDone = LiveRun::WhenDone;

inline constexpr int kStepsOfAnEpisode = 12;  // of 10 ms, in 3 actions

class NotedEvents : public EventSink {
 public:
  void Publish(const json& event) override {
    const std::lock_guard lock(mutex_);
    events_.push_back(event);
  }
  void Show(const ViewFrame& frame) override {
    const std::lock_guard lock(mutex_);
    frames_.push_back(frame);
  }
  std::vector<ViewFrame> frames() {
    const std::lock_guard lock(mutex_);
    return frames_;
  }
  // One value of each event of this kind.
  std::vector<json> Of(const std::string& kind, const char* key) {
    const std::lock_guard lock(mutex_);
    std::vector<json> found;
    for (const json& event : events_) {
      if (event.at("event") == kind) found.push_back(event.at(key));
    }
    return found;
  }

 private:
  std::mutex mutex_;
  std::vector<json> events_;
  std::vector<ViewFrame> frames_;
};

inline RunRecord RecordFor(const std::filesystem::path& folder, int64_t episodes) {
  RunRecord run = SampleRun();
  run.episodes_planned = episodes;
  run.checkpoint_seconds = 0;
  run.record_every = 0;
  run.tasks = {DescribeTask(Plugin(PluginFile("steady")).table(), "task")};
  run.tasks.front().id = 1;
  run.tasks.front().plugin = KeepPlugin(PluginFile("steady"), folder);
  return run;
}

// A run in `folder`, new or to be gone on with, and a thread that trains.
class Trainer {
 public:
  Trainer(const std::filesystem::path& folder, int64_t episodes, WhenDone when_done)
      : database_(RunDatabase::Exists(folder)
                      ? RunDatabase::Open(folder)
                      : RunDatabase::Create(folder, RecordFor(folder, episodes))),
        record_(database_.ReadRun()),
        live_({folder, record_, database_, agent_.graph(), agent_.types(), agent_.context()},
              progress_, when_done, stop_),
        training_(agent_.graph(), record_, database_, progress_, live_) {
    record_.episodes_planned = episodes;
    training_.Restore();
    live_.PublishTo(&events);
  }
  ~Trainer() { Stop(); }

  void Start() {
    thread_ = std::thread([this] { training_.Run(stop_); });
  }
  void Wait() {
    if (thread_.joinable()) thread_.join();
  }
  void Stop() {
    if (!thread_.joinable()) return;
    Send("stop", json::object());
    Wait();
  }

  std::future<Reply> Send(const std::string& command, json arguments) {
    auto promise = std::make_shared<std::promise<Reply>>();
    std::future<Reply> reply = promise->get_future();
    live_.Handle({command, std::move(arguments)},
                 [promise](Reply each) { promise->set_value(std::move(each)); });
    return reply;
  }
  static Reply Take(std::future<Reply> reply) {
    if (reply.wait_for(std::chrono::minutes(1)) != std::future_status::ready) {
      return {false, {}, "there is no reply"};
    }
    return reply.get();
  }
  json Ask(const std::string& command, json arguments = json::object()) {
    const Reply reply = Take(Send(command, std::move(arguments)));
    EXPECT_TRUE(reply.ok) << command << ": " << reply.error;
    return reply.value;
  }
  std::string Refusal(const std::string& command, json arguments = json::object()) {
    const Reply reply = Take(Send(command, std::move(arguments)));
    EXPECT_FALSE(reply.ok) << command;
    return reply.error;
  }
  // Runs `count` steps or episodes, and stands still.
  void Run(int count, const char* unit) {
    Ask("step", {{"count", count}, {"unit", unit}});
    WaitFor("paused");
  }
  void WaitFor(const std::string& state) {
    while (Ask("status")["state"] != state) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  std::pair<int64_t, int64_t> Position() {
    const json status = Ask("status");
    return {status["episode"], status["step"]};
  }

  LiveRun& live() { return live_; }
  Training& training() { return training_; }
  RunDatabase& database() { return database_; }
  const RunRecord& record() const { return record_; }
  SmallAgent& agent() { return agent_; }
  // "4:0 set task.gain = 2.0"
  std::vector<std::string> Changes() const {
    std::vector<std::string> texts;
    for (const ChangeRecord& change : database_.ReadChanges()) {
      texts.push_back(std::to_string(change.episode) + ":" + std::to_string(change.step) + " " +
                      std::string(KindOf(change.change)) + " " + change.text);
    }
    return texts;
  }

  NotedEvents events;

 private:
  SmallAgent agent_;
  StopRequest stop_;
  RunDatabase database_;
  RunRecord record_;
  Progress progress_{ProgressStyle::kQuiet, record_, stdout, stderr};
  LiveRun live_;
  Training training_;
  std::thread thread_;
};

class LiveRunTest : public testing::Test {
 protected:
  // Stands still before the first step.
  Trainer& Begin(int64_t episodes, WhenDone when_done = WhenDone::kWait) {
    trainer_.reset();  // only one at a time can wait for signals
    trainer_.emplace(folder_.path() / "run", episodes, when_done);
    const std::future<Reply> paused = trainer_->Send("pause", json::object());
    trainer_->Start();
    paused.wait();
    return *trainer_;
  }
  // Kills the trainer, which stands still: the next one has what it had written by then.
  void Kill() {
    const std::filesystem::path run = folder_.path() / "run";
    const std::filesystem::path left = folder_.path() / "left";
    std::filesystem::copy(run, left);
    trainer_.reset();
    std::filesystem::remove_all(run);
    std::filesystem::rename(left, run);
  }
  // Trains until there are `episodes`, and once more from nothing but the record.
  void ExpectTheSameFromTheRecord(int64_t episodes) {
    const auto train = [&] {
      Begin(episodes).Ask("resume");
      trainer_->WaitFor("finished");
      trainer_->Stop();
      std::vector<std::pair<double, size_t>> rows;
      for (const EpisodeRecord& each : trainer_->database().ReadEpisodes()) {
        rows.emplace_back(each.active.episode_return, each.shadows.size());
      }
      return std::pair(rows, trainer_->database().ReadCheckpoint()->state);
    };
    const auto gone_on = train();
    trainer_.reset();
    SqliteDatabase(folder_.path() / "run" / "run.db", SqliteAccess::kWrite)
        .Execute("DELETE FROM checkpoint", "forget it");
    EXPECT_EQ(train(), gone_on);
  }
  static json Swap(const char* plugin, bool now) {
    return {{"name", "task"}, {"file", PluginFile(plugin).string()}, {"now", now}};
  }

  TemporaryFolder folder_;
  std::optional<Trainer> trainer_;
};

}  // namespace runtime
