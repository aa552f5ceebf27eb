#include "runtime/trainer/serve/listed_run.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "runtime/analysis/report/base64.h"
#include "runtime/base/user_error.h"
#include "runtime/live/client/page_address.h"
#include "runtime/training/run/return_statistics.h"
#include "runtime/training/run/run_database.h"
#include "runtime/training/run/run_files.h"

namespace runtime {
namespace {

using Json = nlohmann::json;
using Time = std::filesystem::file_time_type;

constexpr size_t kPointsOfSparkline = 60;
constexpr double kKept = 0.9;  // of the time that was measured, from episode to episode

// Its minimum where there is no such file.
Time WrittenAt(const std::filesystem::path& file) {
  std::error_code error;
  const Time time = std::filesystem::last_write_time(file, error);
  return error ? Time::min() : time;
}

std::string AddressOrNothing(const std::filesystem::path& folder) {
  try {
    return PageAddress(folder);
  } catch (const UserError&) {
    return "";
  }
}

double MeanOf(std::span<const float> values) {
  double sum = 0;
  int count = 0;
  for (const float value : values) {
    if (!std::isfinite(value)) continue;
    sum += value;
    ++count;
  }
  return count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

// JSON has no other numbers.
Json FiniteOrNull(double value) { return std::isfinite(value) ? Json(value) : Json(); }

// Means over so many equal parts of all episodes, or each of them where there are fewer.
Json SparklineOf(const std::vector<float>& returns) {
  Json line = Json::array();
  const size_t points = std::min(returns.size(), kPointsOfSparkline);
  for (size_t i = 0; i < points; ++i) {
    const size_t begin = i * returns.size() / points;
    const size_t end = (i + 1) * returns.size() / points;
    line.push_back(FiniteOrNull(MeanOf(std::span(returns).subspan(begin, end - begin))));
  }
  return line;
}

}  // namespace

void ListedRun::Refresh() {
  const Time begun_at = WrittenAt(folder_ / "control.json");
  // With the log in front of it, the database itself may not be written for long.
  const std::filesystem::path database = RunDatabaseFile(folder_);
  const Time written_at =
      std::max({WrittenAt(database), WrittenAt(database.string() + "-wal"), begun_at});
  const bool may_have_ended = state_ == RunState::kRunning;  // a kill writes nothing
  if (written_at == written_at_ && begun_at == begun_at_ && !may_have_ended) return;
  if (begun_at != begun_at_) {
    address_ = AddressOrNothing(folder_);
    returns_.clear();  // it may have gone back to a checkpoint
  }
  written_at_ = written_at;
  begun_at_ = begun_at;
  try {
    Read();
    failure_.clear();
  } catch (const std::exception& error) {
    failure_ = error.what();
  }
}

void ListedRun::Read() {
  if (task_.empty()) ReadFacts();
  const RunDatabase database = RunDatabase::OpenToRead(folder_);
  state_ = database.ReadState();
  planned_ = std::stoll("0" + database.ReadValue("episodes_planned"));
  const auto done = static_cast<int64_t>(returns_.size());
  if (done == 0) {
    best_ = -std::numeric_limits<double>::infinity();
    simulated_seconds_ = wall_seconds_ = episodes_in_them_ = 0;
  }
  for (const EpisodeReturn& each : ReadReturns(folder_, done)) Add(each);
}

void ListedRun::ReadFacts() {
  const RunRecord run = RunDatabase::OpenToRead(folder_).ReadRun();
  robot_ = run.robot;
  profile_ = run.profile;
  seed_ = run.seed;
  task_ = run.tasks.front().task;
}

void ListedRun::Add(const EpisodeReturn& episode) {
  returns_.push_back(static_cast<float>(episode.value));
  if (!episode.has_diverged && std::isfinite(episode.value)) best_ = std::max(best_, episode.value);
  simulated_seconds_ = kKept * simulated_seconds_ + episode.simulated_seconds;
  wall_seconds_ = kKept * wall_seconds_ + episode.wall_seconds;
  episodes_in_them_ = kKept * episodes_in_them_ + 1;
}

double ListedRun::RecentMean() const {
  const size_t count = std::min(returns_.size(), ReturnStatistics::kMeanOver);
  return MeanOf(std::span(returns_).last(count));
}

std::string ListedRun::StateName() const {
  if (!failure_.empty()) return "failed";
  switch (state_) {
    case RunState::kRunning:
      return "running";
    case RunState::kFinished:
      return "finished";
    case RunState::kInterrupted:
      break;
  }
  return "stopped";
}

Json ListedRun::ToJson() const {
  const auto done = static_cast<int64_t>(returns_.size());
  const bool is_measured = wall_seconds_ > 0;
  const double seconds_each = is_measured ? wall_seconds_ / episodes_in_them_ : NAN;
  const double left = seconds_each * static_cast<double>(std::max<int64_t>(0, planned_ - done));
  return {{"task", task_},
          {"robot", robot_},
          {"profile", profile_},
          {"seed", seed_},
          {"state", StateName()},
          {"failure", failure_},
          {"episodes", done},
          {"episodes_planned", planned_},
          {"last_return", FiniteOrNull(returns_.empty() ? NAN : returns_.back())},
          {"mean_return", FiniteOrNull(RecentMean())},
          {"best_return", FiniteOrNull(best_)},
          {"speed", is_measured ? Json(simulated_seconds_ / wall_seconds_) : Json()},
          {"seconds_left", is_trained() ? FiniteOrNull(left) : Json()},
          {"sparkline", SparklineOf(returns_)},
          {"address", is_trained() ? address_ : ""}};
}

Json ListedRun::CurveJson(int64_t episode) const {
  const auto begin =
      static_cast<size_t>(std::clamp<int64_t>(episode, 0, static_cast<int64_t>(returns_.size())));
  return {{"after", begin}, {"returns", EncodeFloats(std::span(returns_).subspan(begin))}};
}

}  // namespace runtime
