// Which memory the rewards and ends of a task depend on, and what that is made of: by what they
// read, by the conditions they are under, and through other memory.
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "compiler/check/checked_task.h"

namespace compiler {

// Something that depends on memory: a reward or an end.
struct Dependent {
  Span span;
  std::set<uint32_t> memory;  // directly
};

struct Dependence {
  std::vector<Dependent> rewards;  // every statement that pays
  std::vector<Dependent> ends;
  // For each memory, the memory and the sensors that it is computed from, or that decide whether it
  // is set.
  std::vector<std::set<uint32_t>> sources;
  std::vector<std::set<uint32_t>> sensors;
  // Memory that only ever holds what was sensed at one moment, or follows from a few such moments:
  // set without condition, and from nothing else that is remembered.
  std::set<uint32_t> sensed;
  // Memory that is only ever added to.
  std::set<uint32_t> accumulated;
};

Dependence DependenceOf(const CheckedTask& task);

// `memory`, and all that it is computed from.
std::set<uint32_t> WithSources(const Dependence& dependence, std::set<uint32_t> memory);

}  // namespace compiler
