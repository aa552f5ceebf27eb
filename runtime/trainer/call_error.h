#pragma once

#include "runtime/base/user_error.h"

namespace runtime {

// The program was called wrongly: exit status 2.
class CallError : public UserError {
 public:
  using UserError::UserError;
};

}  // namespace runtime
