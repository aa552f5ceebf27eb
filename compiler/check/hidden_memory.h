// Memory that the task does not declare, but needs.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "compiler/check/checked_task.h"
#include "compiler/check/type.h"

namespace compiler {

// Adds a variable to the task; its elements begin with 0. Gives its index. `name`: one that no task
// can declare. `span`: of what needs it.
inline uint32_t AddHiddenMemory(std::string name, const Type& type, Unit unit, MemoryScope scope,
                                Span span, CheckedTask& task) {
  CheckedMemory memory{.name = std::move(name),
                       .type = type,
                       .unit = unit,
                       .scope = scope,
                       .initial = {span, ScalarType(type.scalar), unit, Constant{0}},
                       .span = span};
  memory.is_declared = false;
  task.memory.push_back(std::move(memory));
  return static_cast<uint32_t>(task.memory.size() - 1);
}

}  // namespace compiler
