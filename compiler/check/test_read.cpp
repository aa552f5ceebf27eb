#include "compiler/check/test_read.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "compiler/check/names.h"
#include "compiler/check/report.h"
#include "compiler/check/type.h"

namespace compiler {
namespace {

// The index of the entry of this name.
template <typename Entry>
std::optional<uint32_t> Find(const std::vector<Entry>& entries, const std::string& name) {
  const auto found = std::ranges::find(entries, name, &Entry::name);
  if (found == entries.end()) return std::nullopt;
  return static_cast<uint32_t>(found - entries.begin());
}

template <typename Entry>
void AddNames(const std::vector<Entry>& entries, std::vector<std::string>& names) {
  std::ranges::transform(entries, std::back_inserter(names), &Entry::name);
}

// `span`: of the call.
void ReportUnknown(const CallExpression& call, Span span, const Identifier& name,
                   const CheckedTask& task, const TaskScope& scope) {
  if (!scope.knows_names || scope.refused.contains(name.text)) return;
  const bool is_total = call.function.text == kTotal;
  std::vector<std::string> valid;
  std::vector<std::string> other;
  AddNames(task.terms, is_total ? valid : other);
  AddNames(task.metrics, is_total ? other : valid);
  AddNames(task.logs, is_total ? other : valid);
  Help help = Suggest(name.span, name.text, valid, is_total ? "reward terms" : "metrics and logs");
  if (std::ranges::find(other, name.text) != other.end())
    help = WriteInstead(span, fmt::format("{}({})", is_total ? kValue : kTotal, name.text));
  Report(scope.diagnostics, code::kUnknownTerm, name.span,
         is_total ? fmt::format("there is no reward term `{}`", name.text)
                  : fmt::format("there is no metric or log `{}`", name.text),
         {.help = std::move(help)});
}

}  // namespace

std::optional<CheckedExpression> CheckTestRead(const CallExpression& call, Span span,
                                               const Place& place, const TaskScope& scope) {
  const bool is_total = call.function.text == kTotal;
  const NameExpression* name = nullptr;
  if (call.arguments.size() == 1) name = std::get_if<NameExpression>(&call.arguments[0]->node);
  if (name == nullptr) {
    Report(scope.diagnostics, code::kWrongArgument, span,
           fmt::format("`{}` needs the name of a {}", call.function.text,
                       is_total ? "reward term" : "metric or log"),
           {.help = is_total ? "write `total(TERM)`" : "write `value(METRIC)`"});
    return std::nullopt;
  }
  const CheckedTask& task = *place.tested;
  const std::string& text = name->name.text;
  CheckedExpression read{span, ScalarType(Scalar::kReal), {}, Constant{}};
  if (is_total) {
    if (const auto term = Find(task.terms, text)) {
      NoteReference(name->name, ReferenceKind::kTerm, scope);
      read.node = TestRead{TestRead::kTotal, *term};
      return read;
    }
  } else if (const auto metric = Find(task.metrics, text)) {
    NoteReference(name->name, ReferenceKind::kMetric, scope);
    read.unit = task.metrics[*metric].value.unit;
    read.node = TestRead{TestRead::kMetric, *metric};
    return read;
  } else if (const auto log = Find(task.logs, text)) {
    NoteReference(name->name, ReferenceKind::kLog, scope);
    read.unit = task.logs[*log].unit;
    read.node = TestRead{TestRead::kLog, *log};
    return read;
  }
  ReportUnknown(call, span, name->name, task, scope);
  return std::nullopt;
}

}  // namespace compiler
