// How far the runs of a study are, whoever trains them.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "runtime/live/workers/supervisor.h"
#include "runtime/trainer/engines/slurm_queue.h"

namespace runtime {

struct RunStatus {
  RunProgress progress;           // as its record says
  std::optional<SlurmTask> task;  // that trains it, waits to, or was the last to
  bool is_in_queue = false;       // the task has not ended
};

// Of all runs in the folder of the study. Throws UserError where it has been given to a cluster
// that cannot be asked, or there are none.
std::vector<RunStatus> ReadStudyStatus(const std::filesystem::path& folder);

// "finished", "running", "pending", ...: what a person wants to know first.
std::string StateText(const RunStatus& run);
// Lines, each with its end.
std::string StatusText(const std::vector<RunStatus>& runs);
// [{"run", "state", "episodes", "episodes_planned", "task": {"state", "node", "reason"} or null}]
nlohmann::ordered_json StatusJson(const std::vector<RunStatus>& runs);

}  // namespace runtime
