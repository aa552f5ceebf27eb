// What all parts of a task's check share.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "compiler/check/enumeration.h"
#include "compiler/check/references.h"
#include "compiler/check/sensor_catalog.h"
#include "compiler/check/symbol_table.h"
#include "compiler/source/diagnostic.h"

namespace compiler {

// Where an event gives a name to a value.
struct LocalName {
  Span span{};
  bool is_loop = false;  // it is the variable of a `for`, not of a `let`
};

// What a call of a function must know of it.
struct FunctionSignature {
  Identifier name;
  bool is_valid = true;  // false: its declaration is wrong, what calls it is not reported
  std::vector<Local> parameters{};
  std::vector<Span> parameter_spans{};
  Type result{};
  Unit unit{};
};

// What consts, sets and tables stand for. Functions know them as well.
struct NamedConstants {
  std::vector<CheckedConst> consts;
  std::vector<CheckedSet> sets;
  std::vector<CheckedTable> tables;
  std::vector<Identifier> names{};  // of all, with those whose declarations are wrong
  std::set<std::string, std::less<>> used{};
};

class TimeFunctionTable;  // compiler/check/time_functions.h
class StartTable;         // compiler/check/starts.h

struct TaskScope {
  bool has_robot = false;
  // What there is but cannot be read is not known, and nothing that may be of it is unknown.
  bool knows_robot = true;
  bool knows_names = true;      // all that is declared
  bool knows_functions = true;  // all that can be called
  std::vector<Enumeration> enumerations;
  SensorCatalog sensors;
  SymbolTable symbols;
  NamedConstants& constants;
  std::vector<FunctionSignature> functions;
  std::vector<std::string> phases;
  // The names of the current event's values, visible or not.
  std::multimap<std::string, LocalName, std::less<>> locals;
  // Where it is passed on to: a loop looks at the messages of each iteration before they count.
  std::reference_wrapper<Diagnostics> diagnostics;
  // Where the variables of loops are read. Null where there are no loops.
  std::vector<Identifier>* loop_reads = nullptr;
  uint32_t statements = 0;   // of the task so far, with loops written out
  uint32_t loop_parts = 0;   // operators, calls and operands in written out loops so far
  bool is_too_long = false;  // too many of them: that has been reported
  // Names whose declarations were refused or could not be read: what is said of their uses would be
  // misleading. Terms, metrics, logs and the texts of ends are among them.
  std::set<std::string, std::less<>> refused{};
  // Unknown names of which nothing is known to be meant: to say it once is enough.
  mutable std::set<std::string, std::less<>> reported{};
  // In a function: the scope around it, of whose values it reads none.
  const TaskScope* around = nullptr;
  References* references = nullptr;  // null: not wanted
  TimeFunctionTable* time_functions = nullptr;
};

// Where an expression stands, as far as this decides what it may read.
struct Place {
  enum Kind {
    kConstant,
    kMetric,
    kEvent,
    kPotential,
    kFunction,
    kGoal,   // what it is drawn from
    kStart,  // the block of a start
    kObservation,
    kTimed,  // the argument of a time function
    kGiven,  // the value of a `given`: a constant
    kExpect
  };
  Kind kind = kConstant;
  EventKind event = EventKind::kStartOfEpisode;  // of a kEvent
  const CheckedTask* tested = nullptr;           // of a kExpect
  uint32_t* draws = nullptr;          // of a kGoal or a kStart: how many random numbers it has
  const StartTable* start = nullptr;  // of a kStart: what it sets

  bool is_constant() const { return kind == kConstant || kind == kGiven; }

  // Is there a time step whose length is known?
  bool has_time_step() const {
    return kind == kMetric || kind == kTimed ||
           (kind == kEvent && event >= EventKind::kStartOfTimeStep);
  }
};

}  // namespace compiler
