// What a function of the past becomes in C++.
#pragma once

#include <string>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/emit/helper_functions.h"

namespace compiler {

// How C++ calls what a time function works on.
struct TimeFunctionNames {
  std::string value;  // in memory, as are `past` and `next`
  std::string past;
  std::string next;
  std::string now;       // the argument, under a name
  std::string duration;  // empty where it has none
};

// The lines that bring it up to date. `type`: of the argument; `counts_steps`: the duration is a
// number of time steps; `written_out`: up to so many elements are no loop.
std::vector<std::string> AdvanceLines(const CheckedTimeFunction& function, const Type& type,
                                      bool is_start, bool counts_steps,
                                      const TimeFunctionNames& names, uint32_t written_out,
                                      HelperSet& helpers);

}  // namespace compiler
