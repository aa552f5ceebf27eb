#include "compiler/bounds/bounds_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "compiler/bounds/bounds_text.h"
#include "compiler/check/traversal.h"

namespace compiler {
namespace {

// Of the first statement that pays the term in this way.
Unit UnitOf(const CheckedTask& task, uint32_t term, bool is_rate) {
  const CheckedReward* first = nullptr;
  for (const CheckedEvent& event : task.events)
    ForEachStatement(event.body, [&](const CheckedStatement& statement) {
      const auto* reward = std::get_if<CheckedReward>(&statement.node);
      const bool fits = reward != nullptr && reward->term == term && reward->is_rate == is_rate;
      if (first == nullptr && fits) first = reward;
    });
  return first != nullptr ? first->value.unit : Unit{};
}

Unit UnitOfPotential(const CheckedTask& task, uint32_t term) {
  const auto potential = std::ranges::find(task.potentials, term, &CheckedPotential::term);
  return task.memory[potential->last].unit;
}

void AddTerm(const CheckedTask& task, uint32_t index, const TermBounds& term,
             std::vector<BoundsRow>& rows) {
  const std::string& name = task.terms[index].name;
  if (term.rate) rows.push_back({name, "rate", *term.rate, UnitOf(task, index, true), term.causes});
  if (term.payment)
    rows.push_back({name, "payment", *term.payment, UnitOf(task, index, false), term.causes});
  if (term.potential)
    rows.push_back({name, "potential", PaymentOfPotential(*term.potential),
                    UnitOfPotential(task, index), term.causes});
  if (!term.rate && !term.payment && !term.potential)
    rows.push_back({name, "payment", kNothing, {}, {}});
}

std::string KindText(const std::string& kind) {
  if (kind == "rate") return "reward, per second";
  if (kind == "payment") return "reward, each time";
  if (kind == "potential") return "reward, each action";
  return kind;
}

std::string Remarks(const BoundsRow& row) {
  if (IsEmpty(row.value)) return "never happens";
  std::vector<std::string> remarks;
  for (const Cause& cause : row.causes) remarks.push_back(Describe(cause));
  if (row.value.may_be_nan) remarks.emplace_back("may be NaN");
  return fmt::format("{}", fmt::join(remarks, "; "));
}

using Cells = std::array<std::string, 6>;

Cells CellsOf(const BoundsRow& row) {
  const bool has_numbers = row.value.low <= row.value.high;
  return {row.name,
          KindText(row.kind),
          has_numbers ? EndText(row.value.low) : "-",
          has_numbers ? EndText(row.value.high) : "-",
          ToString(row.unit),
          Remarks(row)};
}

}  // namespace

std::vector<BoundsRow> BoundsRows(const CheckedTask& task, const TaskBounds& bounds) {
  std::vector<BoundsRow> rows;
  for (uint32_t i = 0; i < task.terms.size(); ++i) AddTerm(task, i, bounds.terms[i], rows);
  for (size_t i = 0; i < task.metrics.size(); ++i)
    rows.push_back({task.metrics[i].name, "metric", bounds.metrics[i].value,
                    task.metrics[i].value.unit, bounds.metrics[i].causes});
  for (size_t i = 0; i < task.logs.size(); ++i)
    rows.push_back(
        {task.logs[i].name, "log", bounds.logs[i].value, task.logs[i].unit, bounds.logs[i].causes});
  for (size_t i = 0; i < task.observations.size(); ++i)
    rows.push_back({task.observations[i].name, "observation", bounds.observations[i].value,
                    task.observations[i].value.unit, bounds.observations[i].causes});
  return rows;
}

std::string ToTable(const std::vector<BoundsRow>& rows) {
  std::vector<Cells> lines = {{"name", "what", "lowest", "highest", "unit", ""}};
  for (const BoundsRow& row : rows) lines.push_back(CellsOf(row));
  std::array<size_t, 6> widths{};
  for (const Cells& line : lines)
    for (size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  std::string table;
  for (const Cells& line : lines) {
    std::string text =
        fmt::format("  {:<{}}  {:<{}}  {:>{}}  {:>{}}  {:<{}}  {}", line[0], widths[0], line[1],
                    widths[1], line[2], widths[2], line[3], widths[3], line[4], widths[4], line[5]);
    text.erase(text.find_last_not_of(' ') + 1);
    table += text + '\n';
  }
  return table;
}

std::string Describe(const Cause& cause) {
  switch (cause.kind) {
    case Cause::kSensor:
      return fmt::format("the sensor `{}` has no range", cause.name);
    case Cause::kParam:
      return fmt::format("the param `{}` has no range", cause.name);
    case Cause::kTimeStep:
      return "the length of a time step is not known";
    case Cause::kMemory:
      return fmt::format("the memory `{}` has no bound", cause.name);
    case Cause::kOperation:
      break;
  }
  return cause.name;
}

}  // namespace compiler
