// What all parts of a task's check share.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "compiler/check/enumeration.h"
#include "compiler/check/sensor_catalog.h"
#include "compiler/check/symbol_table.h"
#include "compiler/source/diagnostic.h"

namespace compiler {

struct TaskScope {
  bool has_robot = false;
  std::vector<Enumeration> enumerations;
  SensorCatalog sensors;
  SymbolTable symbols;
  // Where the names of the current event are given by a `let`, visible or not.
  std::multimap<std::string, Span, std::less<>> lets;
  Diagnostics& diagnostics;
};

// Where an expression stands, as far as this decides what it may read.
struct Place {
  enum Kind { kConstant, kMetric, kEvent };
  Kind kind = kConstant;
  EventKind event = EventKind::kStartOfEpisode;  // of a kEvent

  // Is there a time step whose length is known?
  bool has_time_step() const {
    return kind == kMetric || (kind == kEvent && event >= EventKind::kStartOfTimeStep);
  }
};

}  // namespace compiler
