#pragma once

#include <taskc/plugin.h>

#include <cstddef>

namespace runtime {

// Bytes of one scalar (TASKC_BOOL, TASKC_INT or TASKC_REAL) in memory; 0 for any other code.
constexpr size_t ScalarSize(int scalar) {
  switch (scalar) {
    case TASKC_BOOL:
      return 1;
    case TASKC_INT:
      return sizeof(taskc_int64);
    case TASKC_REAL:
      return sizeof(double);
    default:
      return 0;
  }
}

// Bytes of all elements of a variable.
constexpr size_t SizeInBytes(const taskc_memory& variable) {
  return ScalarSize(variable.scalar) * variable.rows * variable.columns;
}

}  // namespace runtime
