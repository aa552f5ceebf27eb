// What `train`, `resume` and `serve` have in common.
#pragma once

#include <cstdint>
#include <string>

#include "base/command_line/command.h"
#include "runtime/live/control/live_run.h"
#include "runtime/trainer/runs/guard.h"
#include "runtime/training/run/progress.h"

namespace runtime {

// --json, --quiet and --plain.
struct OutputOptions {
  bool json = false;
  bool quiet = false;
  bool plain = false;

  // `objects`: what --json prints.
  void AddTo(command_line::Command& command,
             const std::string& objects = "one JSON object per episode");
  ProgressStyle style() const;
};

struct SessionOptions {
  OutputOptions output;
  uint16_t port = 0;  // on the loopback; 0: any that is free
  LiveRun::WhenDone when_done = LiveRun::WhenDone::kEnd;
  int jobs = 0;  // episodes at a time, where the learner allows that; 0: one for each core

  SessionOptions At(Pace pace) const;
  // --json, --quiet, --plain and --port
  void AddTo(command_line::Command& command);
};

// Trains until all episodes are done or it is stopped, from the last checkpoint if there is
// one, and answers requests; returns the exit status.
int RunSession(const RunParts& run, const SessionOptions& options);

}  // namespace runtime
