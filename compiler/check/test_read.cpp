#include "compiler/check/test_read.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "compiler/check/expressions.h"
#include "compiler/check/names.h"
#include "compiler/check/phase_names.h"
#include "compiler/check/report.h"
#include "compiler/check/type.h"
#include "compiler/check/written_form.h"

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
std::vector<std::string> NamesOf(const std::vector<Entry>& entries) {
  std::vector<std::string> names;
  std::ranges::transform(entries, std::back_inserter(names), &Entry::name);
  return names;
}

// What can be read by one of the functions.
struct ReadByTest {
  std::string_view function;
  std::string_view what;    // "reward term"
  std::string_view plural;  // "reward terms"
  std::vector<std::string> names;
};

std::vector<ReadByTest> ReadByTests(const CheckedTask& task) {
  std::vector<std::string> recorded = NamesOf(task.metrics);
  std::ranges::move(NamesOf(task.logs), std::back_inserter(recorded));
  return {{kTotal, "reward term", "reward terms", NamesOf(task.terms)},
          {kValue, "metric or log", "metrics and logs", std::move(recorded)},
          {kObserved, "observation", "observations", NamesOf(task.observations)}};
}

class TestReadCheck {
 public:
  TestReadCheck(const CallExpression& call, Span span, const Place& place, const TaskScope& scope)
      : call_(call), span_(span), place_(place), scope_(scope), task_(*place.tested) {}

  std::optional<CheckedExpression> Check() {
    const std::optional<Identifier> name = Name();
    if (!name) return NeedsName();
    if (call_.function.text == kTotal) {
      if (const auto term = Find(task_.terms, name->text))
        return Read(*name, ReferenceKind::kTerm, TestRead::kTotal, *term, {});
    } else if (call_.function.text == kObserved) {
      if (const auto index = Find(task_.observations, name->text)) return Observed(*name, *index);
    } else if (const auto metric = Find(task_.metrics, name->text)) {
      return Read(*name, ReferenceKind::kMetric, TestRead::kMetric, *metric,
                  task_.metrics[*metric].value.unit);
    } else if (const auto log = Find(task_.logs, name->text)) {
      return Read(*name, ReferenceKind::kLog, TestRead::kLog, *log, task_.logs[*log].unit);
    }
    ReportUnknown(*name);
    return std::nullopt;
  }

 private:
  // Those of observations may have dots, and be indexed.
  std::optional<Identifier> Name() const {
    if (call_.arguments.size() != 1) return std::nullopt;
    const Expression& argument = *call_.arguments[0];
    if (const auto* name = std::get_if<NameExpression>(&argument.node)) return name->name;
    if (call_.function.text != kObserved) return std::nullopt;
    const auto text = WrittenForm(argument);
    return text ? std::optional(Identifier{*text, argument.span}) : std::nullopt;
  }

  std::nullopt_t NeedsName() const {
    const bool is_total = call_.function.text == kTotal;
    const bool is_observed = call_.function.text == kObserved;
    Report(scope_.diagnostics, code::kWrongArgument, span_,
           fmt::format("`{}` needs the name of a{}", call_.function.text,
                       is_total      ? " reward term"
                       : is_observed ? "n observation"
                                     : " metric or log"),
           {.help = is_total      ? "write `total(TERM)`"
                    : is_observed ? "give the observation a name: `observe NAME = ...`"
                                  : "write `value(METRIC)`"});
    return std::nullopt;
  }

  CheckedExpression Read(const Identifier& name, ReferenceKind kind, TestRead::Kind read,
                         uint32_t index, Unit unit) const {
    NoteReference(name, kind, scope_);
    return {span_, kRealType, unit, TestRead{read, index}};
  }

  CheckedExpression Observed(const Identifier& name, uint32_t index) const {
    const CheckedObservation& observation = task_.observations[index];
    if (observation.has_name) {
      NoteReference(name, ReferenceKind::kObservation, scope_);
    } else {
      // Its name is made of others, which tools know here as well.
      const Expression& argument = *call_.arguments[0];
      if (!PhaseFlags(argument, scope_)) CheckExpression(argument, place_, scope_);
    }
    return {span_, observation.value.type, observation.value.unit,
            TestRead{TestRead::kObservation, index}};
  }

  void ReportUnknown(const Identifier& name) const {
    if (!scope_.knows_names || scope_.refused.contains(name.text)) return;
    const std::vector<ReadByTest> all = ReadByTests(task_);
    const ReadByTest& wanted = *std::ranges::find(all, call_.function.text, &ReadByTest::function);
    Help help = Suggest(name.span, name.text, wanted.names, wanted.plural);
    for (const ReadByTest& other : all)
      if (std::ranges::find(other.names, name.text) != other.names.end())
        help = WriteInstead(span_, fmt::format("{}({})", other.function, name.text));
    Report(scope_.diagnostics, code::kUnknownTerm, name.span,
           fmt::format("there is no {} `{}`", wanted.what, name.text), {.help = std::move(help)});
  }

  const CallExpression& call_;
  Span span_;
  const Place& place_;
  const TaskScope& scope_;
  const CheckedTask& task_;
};

}  // namespace

std::optional<CheckedExpression> CheckTestRead(const CallExpression& call, Span span,
                                               const Place& place, const TaskScope& scope) {
  return TestReadCheck(call, span, place, scope).Check();
}

}  // namespace compiler
