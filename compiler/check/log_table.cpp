#include "compiler/check/log_table.h"

#include <algorithm>
#include <utility>

#include "compiler/check/conversion.h"
#include "compiler/check/expressions.h"
#include "compiler/check/names.h"
#include "compiler/check/report.h"
#include "compiler/syntax/words.h"

namespace compiler {
std::optional<CheckedLog> LogTable::Check(const LogStatement& log, const Place& place) {
  NoteReference(log.name, ReferenceKind::kLog, scope_);
  const uint32_t index = Declare(log);
  CheckReduction(log, task_.logs[index]);
  auto value = CheckRealNumber(log.value, "a log", place, scope_);
  if (!value || !CheckUnit(log, index, *value)) return std::nullopt;
  return CheckedLog{index, std::move(*value)};
}

// The log of this name, which is new with its first statement.
uint32_t LogTable::Declare(const LogStatement& log) {
  const std::string& name = log.name.text;
  const auto found = std::ranges::find(task_.logs, name, &CheckedLogValue::name);
  const auto index = static_cast<uint32_t>(found - task_.logs.begin());
  if (found != task_.logs.end()) {
    if (found->doc.empty()) found->doc = log.doc;
    return index;
  }
  task_.logs.push_back({.name = name,
                        .doc = log.doc,
                        .unit = {},
                        .reduction = log.reduction,
                        .span = log.name.span});
  const auto metric = std::ranges::find(task_.metrics, name, &CheckedMetric::name);
  if (metric != task_.metrics.end())
    Report(scope_.diagnostics, code::kRepeatedName, log.name.span,
           fmt::format("there is already a metric `{}`", name),
           {.help = "a log and a metric are curves beside each other: choose another name",
            .labels = {{metric->span, "first declared here"}}});
  return index;
}

void LogTable::CheckReduction(const LogStatement& log, const CheckedLogValue& first) const {
  if (log.reduction == first.reduction) return;
  const std::string_view word = NameOf(first.reduction, kReductionNames);
  Report(scope_.diagnostics, code::kDifferentLogs, log.name.span,
         fmt::format("`{}` is logged as `{}` elsewhere", first.name, word),
         {.note = fmt::format("here as `{}`", NameOf(log.reduction, kReductionNames)),
          .help = first.reduction == Reduction::kLast
                      ? "reduce it in the same way, or choose another name"
                      : fmt::format("write `log {} {} = ...`, or choose another name", word,
                                    first.name),
          .labels = {{first.span, "first logged here"}}});
}

// A literal 0 fits every unit.
bool LogTable::CheckUnit(const LogStatement& log, uint32_t index, CheckedExpression& value) {
  CheckedLogValue& first = task_.logs[index];
  if (IsLiteralZero(&log.value)) {
    value.unit = first.unit;
    return true;
  }
  if (with_unit_.insert(index).second) first.unit = value.unit;
  if (value.unit == first.unit) return true;
  Report(
      scope_.diagnostics, code::kDifferentLogs, value.span,
      fmt::format("`{}` is logged as {} elsewhere", first.name, NameOf(first.unit)),
      {.note = fmt::format("this is {}{}", value.unit == Unit{} ? "" : "in ", NameOf(value.unit)),
       .help = HelpForUnit(value.unit, &log.value, first.unit),
       .labels = {{first.span, "first logged here"}}});
  return false;
}

}  // namespace compiler
