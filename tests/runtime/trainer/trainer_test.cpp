#include "tests/runtime/trainer/trainer_test.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <thread>

namespace runtime {

void TrainerTest::WaitForAStep(const std::string& name) const {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point deadline = Clock::now() + std::chrono::minutes(1);
  while (Clock::now() < deadline) {
    const ProgramResult status = Trainer({"ctl", "--run", RunFolder(name), "status", "--json"});
    const bool is_answered = status.exit_status == 0;
    if (is_answered && status.output.find("\"step\":0,") == std::string::npos) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  FAIL() << "the run has not begun its first episode within a minute";
}

TrainerTest::Trace TrainerTest::TraceOf(const std::string& name) const {
  const RunDatabase database = RunDatabase::OpenToRead(RunFolder(name));
  Trace trace;
  for (const EpisodeRecord& episode : database.ReadEpisodes()) {
    trace.episodes.push_back(
        fmt::format("{} return {:a} end {} {} steps {} actions {} time {:a} faults {} terms {::a} "
                    "metrics {::a} logs {::a} violations {}",
                    episode.number, episode.active.episode_return, episode.active.end_kind,
                    episode.active.end_reason, episode.steps, episode.actions,
                    episode.simulated_seconds, episode.active.faults, episode.active.terms,
                    episode.active.metrics, episode.active.logs, episode.active.violations));
    const std::optional<Recording> recording = database.ReadRecording(episode.number);
    trace.recordings.push_back(recording ? recording->poses + recording->timeline : "");
  }
  return trace;
}

}  // namespace runtime
