// What the lets of a task are worth, without running it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/check/value.h"

namespace compiler {

struct LetWorth {
  std::string name;
  Type type;
  Unit unit;
  Value value;
};

// What a host knows of a moment, by the names of sensors, params, memory and goals: their elements
// in SI units, a bool as 0 or 1. What the task does not have, or has in another size, is ignored.
using KnownNumbers = std::map<std::string, std::vector<double>>;

// Of each let of an event or a phase whose equation leads to what is known alone: its value,
// whether the event would come to it or not. Of lets with the same name, and of those in loops,
// none.
std::vector<LetWorth> LetsWorth(const CheckedTask& task, const KnownNumbers& known);

}  // namespace compiler
