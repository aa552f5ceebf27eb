// What there is to say about a run in a few lines.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "runtime/training/run/return_statistics.h"
#include "runtime/training/run/run_records.h"
#include "runtime/training/run/task_spans.h"

namespace runtime {

// A shadow that was there in the last episode.
struct ShadowOverview {
  TaskRecord task;
  double last_return = 0;
  double mean_return = 0;  // over the last episodes, of those in which it was there
};

struct RunOverview {
  RunRecord run;
  std::string state;
  std::string started_at;
  std::string finished_at;
  int64_t episodes = 0;
  int64_t checkpoint_episode = 0;  // from which `resume` continues
  ReturnStatistics returns;
  double simulated_seconds = 0;
  double wall_seconds = 0;
  int64_t faults = 0;
  int64_t violations = 0;
  TaskRecord task;              // the one that was active last
  std::vector<double> metrics;  // of this task, each one's mean over the last episodes
  std::vector<double> logs;
  std::vector<GoalDraw> goals;  // what the robot was told last: one for each goal
  std::vector<PhaseSums> phases;
  std::map<std::pair<std::string, std::string>, int64_t> ends;  // by kind and reason
  std::vector<NamedValue> learner;                              // of the last episode
  std::vector<TaskSpan> versions;
  // What each version but the first changed (runtime/analysis/report/version_difference.h); empty:
  // nothing, or not known.
  std::vector<std::string> differences;
  std::vector<ShadowOverview> shadows;
  std::vector<ChangeRecord> changes;
};

RunOverview ReadOverview(const std::filesystem::path& folder);

// Lines for a person.
std::string OverviewText(const RunOverview& overview);
nlohmann::ordered_json OverviewJson(const RunOverview& overview);

}  // namespace runtime
