// A study: which tasks are learned how often, and for how long.
//
//   episodes = 1000
//   profile = "fast"
//   seeds = [1, 2, 3]                # or "1..10"
//
//   [[experiments]]
//   task = "../tasks/crawling.task"  # from the folder of this file
//   episodes = 1500                  # what an experiment does not say is said above
//
//   [slurm]                          # for `--engine slurm`
//   partition = "cpu"
//   time = "12:00:00"
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "runtime/trainer/setup/create_run.h"
#include "runtime/trainer/setup/slurm_settings.h"
#include "runtime/trainer/setup/task_setup.h"

namespace runtime {

struct Experiment {
  std::string name;   // of its folder; "" where the file names none: TASK-PROFILE
  std::string place;  // "study.toml:5:1", for messages
  TaskOptions task;
  RunPlan plan;  // of each run, with its own seed
  std::vector<uint64_t> seeds;
};

struct StudyPlan {
  std::vector<Experiment> experiments;
  SlurmSettings slurm;
};

// Throws UserError with file, line and column.
StudyPlan ReadStudy(const std::filesystem::path& file);

}  // namespace runtime
