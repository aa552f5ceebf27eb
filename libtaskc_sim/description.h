// What a `taskc_sim` says of itself.
#pragma once

#include <taskc/sim.h>

#include <string>
#include <vector>

#include "runtime/core/module/observations.h"
#include "runtime/trainer/environment/decision_process.h"
#include "runtime/trainer/setup/task_setup.h"

namespace libtaskc_sim {

class Description {
 public:
  // `setup` outlives this object. `process`: one of those that were made from it.
  Description(const runtime::TaskSetup& setup, const runtime::DecisionProcess& process,
              size_t threads, size_t count);
  Description(const Description&) = delete;
  Description& operator=(const Description&) = delete;

  const taskc_sim_description& shown() const { return shown_; }

 private:
  const runtime::ObservationLayout layout_;
  const std::string profile_;
  std::vector<taskc_sim_observation> observations_;
  taskc_sim_description shown_{};
};

}  // namespace libtaskc_sim
