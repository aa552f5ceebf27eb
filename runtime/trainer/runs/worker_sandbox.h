// The process that trains a run, before it runs code of a task: what it opens, and then gives up.
#pragma once

#include <filesystem>
#include <utility>

#include "runtime/base/sandbox.h"
#include "runtime/live/server/descriptor.h"
#include "runtime/trainer/runs/run_session.h"

namespace runtime {

class WorkerSandbox {
 public:
  // Opens what cannot be opened later. Throws UserError where the port that was asked for cannot be
  // had.
  explicit WorkerSandbox(const SessionOptions& session);

  // From then on the compiler runs outside, and nothing but `rules` can be reached.
  void Enter(const SandboxRules& rules);
  // Takes away the other runs, where the folder of this one was not known before.
  void NarrowTo(const std::filesystem::path& folder) const;

  // Listens on the loopback; not open where no port could be had. The caller's from then on.
  Descriptor TakeLoopback() { return std::move(loopback_); }

 private:
  const bool is_wanted_;
  Descriptor loopback_;
  SandboxRules rules_;
};

}  // namespace runtime
