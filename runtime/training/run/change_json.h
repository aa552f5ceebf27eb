// How changes are written in a run's record (column `data` of the table `change`): as a JSON object
// with the member `command` and what the kind has to say.
#pragma once

#include <cstdint>
#include <string>

#include "runtime/training/run/change.h"

namespace runtime {

std::string ChangeData(const Change& change);

// The change that stands in the record as `data`, in a run of so many tasks. Throws UserError with
// what is wrong about it, such as "has no `name`". Kinds that only another version of the trainer
// knows may say what they like.
Change ReadChange(const std::string& kind, const std::string& data, int64_t task_count);

}  // namespace runtime
