#pragma once

#include "runtime/base/user_error.h"

namespace runtime {

// What a run's folder keeps, its database or a plugin, cannot be read or written: because of the
// disk or another program, never because of what somebody changed in the run.
class RecordError : public UserError {
 public:
  using UserError::UserError;
};

}  // namespace runtime
