#pragma once

#include "fuzz/targets.h"
#include "plugins/robot/robot_description.h"
#include "runtime/base/user_error.h"

namespace fuzz {

// Whether `read` has read it, or has refused it with an error for users. Each such error has a
// text; any other exception ends the fuzzer.
template <class Read>
bool ReadOrRefuse(const Read& read) {
  try {
    read();
    return true;
  } catch (const runtime::UserError& error) {
    Require(*error.what() != '\0', "an error says nothing");
  } catch (const robot::DescriptionError& error) {
    Require(*error.what() != '\0', "an error says nothing");
  }
  return false;
}

}  // namespace fuzz
