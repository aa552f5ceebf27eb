// Where the runs of a study are trained: on this machine, or by a batch system. Both start the same
// worker for a run, `trainer resume`, which goes on from the run's last checkpoint.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "runtime/trainer/runs/run_session.h"

namespace runtime {

struct StudyRuns {
  std::filesystem::path folder;             // of the study
  std::vector<std::filesystem::path> runs;  // their folders, below it, in their order
};

class Engine {
 public:
  virtual ~Engine() = default;
  // Trains those of the runs that are not finished, or sees to it that they will be; returns the
  // exit status. Throws UserError.
  virtual int Train(const StudyRuns& study, const OutputOptions& output) = 0;
};

// On this machine, `jobs` runs at a time (0: as many as there are cores), until all are finished.
std::unique_ptr<Engine> MakeLocalEngine(int jobs);

}  // namespace runtime
