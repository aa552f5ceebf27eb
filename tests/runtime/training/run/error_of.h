// For tests of what the user is told.
#pragma once

#include <string>

#include "runtime/base/user_error.h"

namespace runtime {

// The message of the UserError that `action` throws; "" if it throws none.
template <class Action>
std::string ErrorOf(const Action& action) {
  try {
    action();
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

}  // namespace runtime
