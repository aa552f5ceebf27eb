#pragma once

#include <string>

#include "runtime/training/run/change.h"
#include "runtime/training/run/run_records.h"

namespace runtime {

// A change for a person: "swap task: crawling (a1b2c3d4)". `run` has the tasks that it names.
std::string TextOf(const Change& change, const RunRecord& run);

}  // namespace runtime
