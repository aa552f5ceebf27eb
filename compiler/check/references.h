// What the names in a task stand for, for tools that show its source: Check() fills it.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "compiler/check/checked_task.h"

namespace compiler {

enum class ReferenceKind {
  kSensor,
  kParam,
  kConst,
  kSet,
  kTable,
  kMemory,
  kGoal,
  kLocal,     // of a `let`
  kLoop,      // the variable of a `for`
  kArgument,  // of a function
  kFunction,
  kPhase,
  kObservation,
  kTerm,
  kMetric,
  kLog
};

struct Reference {
  ReferenceKind kind = ReferenceKind::kParam;
  std::string name{};
  Span use{};         // where the name stands; a declaration is a use of itself
  Span definition{};  // of the name where it is first declared; empty for a robot's sensor
  Type type{};        // of values
  Unit unit{};

  bool has_definition() const { return definition.end > definition.begin; }
};

class References {
 public:
  // Where a loop's body is checked many times, the first time counts.
  void Add(const Reference& reference) { by_place_.try_emplace(reference.use.begin, reference); }
  // A name that is declared, or used, where it stands: what stands there first is the definition.
  // For names that are unique in the task.
  void AddUnique(Reference reference);

  // By the offset at which the use begins.
  const std::map<uint32_t, Reference>& by_place() const { return by_place_; }
  // The reference whose name the offset touches, or null.
  const Reference* Find(uint32_t offset) const;

 private:
  std::map<uint32_t, Reference> by_place_;
  std::map<std::pair<ReferenceKind, std::string>, Span> unique_;  // where it is declared
};

}  // namespace compiler
