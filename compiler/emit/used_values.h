// What the code of one function refers to, so that it names nothing else at its start, and how long
// it is.
#pragma once

#include <set>

#include "compiler/check/checked_task.h"
#include "compiler/emit/code_size.h"

namespace compiler {

struct UsedValues {
  std::set<uint32_t> consts;  // with a shape
  std::set<uint32_t> tables;
  std::set<uint32_t> sensors;
  std::set<uint32_t> params;
  std::set<uint32_t> locals;
  std::set<uint32_t> arguments;
  bool memory = false;
  bool reward = false;  // pays a term or reads the sum so far
  bool draws = false;   // takes random numbers
  bool frame = false;   // any of the above but locals and arguments, or what else the frame holds
  CodeSize size;

  void Add(const CheckedExpression& expression);
  void Add(const CheckedBlock& block);
  // A value that is computed by a statement of its own.
  void AddStatement(const CheckedExpression& value);
  // Memory is given its initial value.
  void AddReset(const CheckedMemory& variable);
};

// What all functions of the plugin refer to.
UsedValues UsedBy(const CheckedTask& task);

// Whether the value depends on the memory variable.
bool Reads(const CheckedExpression& expression, uint32_t memory);

}  // namespace compiler
