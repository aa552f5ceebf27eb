// What `train`, `resume` and `serve` have in common.
#pragma once

#include <cstdint>
#include <string>

#include "base/command_line/command.h"
#include "runtime/live/control/live_run.h"
#include "runtime/live/server/descriptor.h"
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
  // Whether the process enters the sandbox for good before it loads the task, unless the user wants
  // none: for one that does nothing but this.
  bool in_sandbox = false;
  int jobs = 0;  // episodes at a time, where the learner allows that; 0: one for each core

  SessionOptions At(Pace pace) const;
  // --json, --quiet, --plain, --port and --no-sandbox
  void AddTo(command_line::Command& command);
};

// Trains until all episodes are done or it is stopped, from the last checkpoint if there is
// one, and answers requests; returns the exit status. `loopback`: listens there already for those
// clients; if it is not open, the server looks for a port itself.
int RunSession(const RunParts& run, const SessionOptions& options, Descriptor loopback);

}  // namespace runtime
