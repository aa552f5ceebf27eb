// The bounds of a task as a table, for a person or another program.
#pragma once

#include <string>
#include <vector>

#include "compiler/bounds/bounds.h"
#include "compiler/check/checked_task.h"

namespace compiler {

struct BoundsRow {
  std::string name;  // of the term, metric or log
  std::string kind;  // "rate", "payment", "metric", "log"
  Interval value;    // empty where it is never computed
  Unit unit;         // of a rate without the 1/s that it is paid by
  std::vector<Cause> causes;
};

// Each term by what it pays per second and each time, then metrics, then logs.
std::vector<BoundsRow> BoundsRows(const CheckedTask& task, const TaskBounds& bounds);

// In columns, with a header; each line indented by two blanks.
std::string ToTable(const std::vector<BoundsRow>& rows);

// "the sensor `speed`, which has no range"
std::string Describe(const Cause& cause);

}  // namespace compiler
