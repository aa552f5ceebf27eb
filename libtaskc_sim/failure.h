// How the functions of sim.h fail: what the runtime throws becomes a status.
#pragma once

#include <taskc/sim.h>

#include "libtaskc/failure.h"

namespace libtaskc_sim {

using libtaskc::Failure;
using libtaskc::RequirePointer;

// The status of the exception that is being handled, whose message is kept. `of_runtime`: of what
// the runtime says is wrong.
taskc_status KeepHandled(taskc_status of_runtime) noexcept;

// Calls `action`; what it throws becomes the status.
template <class Action>
taskc_status Guarded(taskc_status of_runtime, Action action) noexcept {
  try {
    action();
    return TASKC_OK;
  } catch (...) {
    return KeepHandled(of_runtime);
  }
}

}  // namespace libtaskc_sim
