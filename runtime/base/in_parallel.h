#pragma once

#include <cstddef>
#include <functional>

namespace runtime {

// Calls work(0), work(1), ..., work(count - 1) on all cores, each in the thread that is free first,
// and returns when all are done. Of what they throw, the exception of the least number is thrown.
void InParallel(size_t count, const std::function<void(size_t)>& work);

}  // namespace runtime
