// What Slurm says of the tasks of job arrays.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/trainer/engines/slurm_jobs.h"

namespace runtime {

struct SlurmTask {
  std::string state;   // "RUNNING"
  std::string node;    // "" where it does not run
  std::string reason;  // why it waits; "" where it does not
};

// By the runs' folders, relative to the study's.
using SlurmTasks = std::map<std::string, SlurmTask>;

// Those of the arrays that wait or run. Throws UserError where `squeue` cannot be asked.
SlurmTasks QueuedTasks(const std::vector<SlurmArray>& arrays);

// How those ended that are not in the queue any more: of each run its last task. None where the
// cluster does not keep accounts.
SlurmTasks EndedTasks(const std::vector<SlurmArray>& arrays);

// What `squeue` prints with kQueueFormat, of all jobs of the user; lines that are none are ignored.
inline constexpr const char* kQueueFormat = "%F|%K|%T|%N|%r";
SlurmTasks ParseQueue(std::string_view text, const std::vector<SlurmArray>& arrays);
// What `sacct` prints with --format=JobID,State,NodeList --parsable2.
SlurmTasks ParseAccounts(std::string_view text, const std::vector<SlurmArray>& arrays);

}  // namespace runtime
