// How much a function of the plugin is for the C++ compiler.
#pragma once

#include <cstdint>

#include "compiler/check/checked_task.h"

namespace compiler {

// A C++ compiler takes far more than linear time to optimize a long function: g++ took a minute for
// 1,300 reward terms, and a third of a second without optimization. So long functions are compiled
// without, to the same bits.
class CodeSize {
 public:
  // What every statement costs, and what its expressions cost.
  void AddStatement() { operations_ += kPerStatement; }
  void Add(const CheckedExpression& expression);

  // Beyond what a C++ compiler optimizes in about a second.
  bool IsLong() const { return operations_ > kMostOperations; }

 private:
  static constexpr uint64_t kMostOperations = 3000;
  static constexpr uint64_t kPerStatement = 10;  // most of them branch

  uint64_t operations_ = 0;
};

}  // namespace compiler
