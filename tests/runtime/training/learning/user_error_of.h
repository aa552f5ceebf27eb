#pragma once

#include <string>

#include "runtime/base/user_error.h"

namespace runtime {

// What the call complains of; "" if it does not.
template <class Call>
std::string UserErrorOf(Call call) {
  try {
    call();
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

}  // namespace runtime
