// What the user said about a run when it was made: what was set, and the command that makes it
// again.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runtime/training/run/run_records.h"

namespace runtime {

struct Setting {
  std::string name;    // "task.fall_penalty"
  std::string value;   // as in an agent file: "8.0"
  std::string origin;  // "--set", or the place in a file: "warm.toml:3:1"
};

// The texts of a RunRecord, and what they say. A run of a version that did not write them down has
// no settings and no call.
std::string SettingsText(const std::vector<Setting>& settings);
std::string CallText(const std::vector<std::string>& words);
std::vector<Setting> SettingsOf(const RunRecord& run);

// [{"name", "value", "origin"}], for programs and pages.
nlohmann::ordered_json SettingsJson(const RunRecord& run);

// "TASK-PROFILE", or "TASK" where the environment has no profiles: how folders of such runs are
// called.
std::string NameOfRuns(const RunRecord& run);
// "robot humanoid, profile fast", "no robot"
std::string RobotText(const RunRecord& run);

// For a shell: "trainer train tasks/crawling.task --set task.weight=2 --profile fast --episodes
// 1000
// --seed 1". It makes the run again, as it was before clients changed it, from the same text of the
// task. `runs`: so many of them, with seeds counted up. "" where the call is not known.
std::string TrainCommand(const RunRecord& run, int64_t runs = 1);

}  // namespace runtime
