// A run as it is read again and again, whoever trains it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "runtime/training/run/read_returns.h"
#include "runtime/training/run/run_records.h"

namespace runtime {

class ListedRun {
 public:
  explicit ListedRun(std::filesystem::path folder) : folder_(std::move(folder)) {}

  const std::filesystem::path& folder() const { return folder_; }
  // Whether a trainer works on it.
  bool is_trained() const { return state_ == RunState::kRunning && failure_.empty(); }

  // Reads what has changed since; of a run that cannot be read, why.
  void Refresh();
  // All that its record says, and where its page is while it is trained (docs/api.md, `runs`).
  nlohmann::json ToJson() const;
  // The returns of the episodes after `episode` (docs/api.md, `curve`).
  nlohmann::json CurveJson(int64_t episode) const;

 private:
  void Read();
  void ReadFacts();
  void Add(const EpisodeReturn& episode);
  double RecentMean() const;
  std::string StateName() const;

  std::filesystem::path folder_;
  std::filesystem::file_time_type written_at_;  // what was read: as it was then
  std::filesystem::file_time_type begun_at_;    // when the trainer began that wrote it
  std::string address_;                         // of that trainer's page; "": there is none
  std::string failure_;
  std::string task_, robot_, profile_;
  uint64_t seed_ = 0;
  int64_t planned_ = 0;
  RunState state_ = RunState::kInterrupted;
  std::vector<float> returns_;  // of each episode
  double best_ = -std::numeric_limits<double>::infinity();
  double simulated_seconds_ = 0, wall_seconds_ = 0;  // of the last episodes, as LiveRun has it
  double episodes_in_them_ = 0;
};

}  // namespace runtime
