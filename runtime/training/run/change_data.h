// What a change says of itself (ChangeRecord::data), before anybody relies on it.
#pragma once

#include <cstdint>
#include <string>

namespace runtime {

// What is wrong with `data` for a change of this kind in a run of so many tasks, such as "has no
// `name`"; "" for nothing. Kinds that only another version of the trainer knows may say what they
// like.
std::string WhatIsWrongWithChange(const std::string& kind, const std::string& data,
                                  int64_t task_count);

}  // namespace runtime
