// Slurm: each run is a task of a job array, with its own database and checkpoint in the study's
// folder, which all nodes share.
#pragma once

#include <memory>
#include <string>

#include "runtime/trainer/engines/engine.h"
#include "runtime/trainer/setup/slurm_settings.h"

namespace runtime {

// Submits the runs that are neither finished nor in the queue, and does not wait for them. A task
// whose node died or that had to make room is requeued, and one whose time is nearly up requeues
// itself: the run goes on from its last checkpoint.
std::unique_ptr<Engine> MakeSlurmEngine(SlurmSettings settings);

// The script of a job array's tasks. `trainer`: the program; `list`: a file with the folder of a
// run on each line, that of task 0 first.
std::string SlurmScript(const std::string& trainer, const std::string& list,
                        const SlurmSettings& settings);

}  // namespace runtime
