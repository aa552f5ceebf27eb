#include "compiler/check/time_functions.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <string>
#include <utility>

#include "compiler/check/conversion.h"
#include "compiler/check/copy_checked.h"
#include "compiler/check/expressions.h"
#include "compiler/check/fold.h"
#include "compiler/check/hidden_memory.h"
#include "compiler/check/report.h"
#include "compiler/check/type.h"

namespace compiler {
namespace {

constexpr Unit kTimeUnit{.second = 1};

// The numbers that all delays of a task remember together.
constexpr uint32_t kLongestPast = 65536;

bool Misplaced(const TimeFunctionDescription& description, const Place& place, Span span,
               const TaskScope& scope) {
  std::string why;
  switch (place.kind) {
    case Place::kEvent:
    case Place::kMetric:
    case Place::kObservation:
    case Place::kPotential:
      return false;
    case Place::kTimed:  // inside another one
      return false;
    case Place::kConstant:
    case Place::kGiven:
      why = "and this must be known before the task runs";
      break;
    case Place::kFunction:
      why = "and a function remembers nothing";
      break;
    case Place::kGoal:
      why = "and a goal is drawn from params and memory";
      break;
    case Place::kStart:
      why = "and an episode has no past before it begins";
      break;
    case Place::kExpect:
      why = "and a test sees only what the task itself reads";
      break;
  }
  const bool is_function = place.kind == Place::kFunction;
  Report(scope.diagnostics, code::kMisplacedTimeFunction, span,
         fmt::format("`{}` looks back in time, {}", description.name, why),
         {.help = is_function ? "give the function a parameter for it"
                              : "read it in an event, a metric, an observation or a potential"});
  return true;
}

bool CheckCount(const TimeFunctionDescription& description, const CallExpression& call, Span span,
                const TaskScope& scope) {
  const size_t wanted = description.takes_duration ? 2 : 1;
  if (call.arguments.size() == wanted) return true;
  Report(scope.diagnostics, code::kWrongArgumentCount, span,
         fmt::format("`{}` takes {} argument{}, not {}", description.name, wanted,
                     wanted == 1 ? "" : "s", call.arguments.size()),
         {.help = fmt::format("write `{}`", description.usage)});
  return false;
}

bool CheckArgument(const TimeFunctionDescription& description, const CheckedExpression& value,
                   const TaskScope& scope) {
  const bool is_any = description.function == TimeFunction::kPrevious ||
                      description.function == TimeFunction::kDelay;
  if (is_any || IsBool(value.type) == description.takes_condition) return true;
  Report(scope.diagnostics, code::kWrongArgument, value.span,
         fmt::format("`{}` needs {}", description.name,
                     description.takes_condition ? "a condition" : "a number"),
         {.note = fmt::format("this is {}", WithArticle(value.type)),
          .help = description.takes_condition ? "compare it, as in `x > 0`" : ""});
  return false;
}

Type WithScalar(Type type, Scalar scalar) {
  type.scalar = scalar;
  return type;
}

Unit PerSecond(Unit unit) {
  --unit.second;
  return unit;
}

struct Result {
  Type type;
  Unit unit;
};
Result ResultOf(TimeFunction function, const CheckedExpression& value) {
  switch (function) {
    case TimeFunction::kPrevious:
    case TimeFunction::kChange:
    case TimeFunction::kDelay:
    case TimeFunction::kSmooth:
      return {value.type, value.unit};
    case TimeFunction::kRate:
      return {value.type, PerSecond(value.unit)};
    case TimeFunction::kHeld:
    case TimeFunction::kRising:
    case TimeFunction::kFalling:
      return {value.type, {}};
    case TimeFunction::kSince:
      return {WithScalar(value.type, Scalar::kReal), kTimeUnit};
  }
  return {};
}

// What is kept of the past: the value itself, or for how long a condition has held.
Result PastOf(TimeFunction function, const CheckedExpression& value) {
  if (function == TimeFunction::kHeld) return {WithScalar(value.type, Scalar::kReal), kTimeUnit};
  return {value.type, value.unit};
}

// How long the past is: a time, or a number of time steps.
class DurationCheck {
 public:
  DurationCheck(const TimeFunctionDescription& description, const Expression& written,
                const CheckedTask& task, const TaskScope& scope)
      : description_(description), written_(written), task_(task), scope_(scope) {}

  std::optional<CheckedExpression> Check() {
    auto duration = CheckExpression(written_, {Place::kMetric}, scope_);
    if (!duration) return std::nullopt;
    const bool is_param = std::holds_alternative<ParamRead>(duration->node);
    if (!is_param && !ValueOf(*duration))
      return Wrong(duration->span, "the length of time must be a constant or a param");
    const bool counts_steps =
        description_.function == TimeFunction::kDelay && duration->type.scalar == Scalar::kInt;
    if (!counts_steps) {
      duration = ConvertTo({std::move(*duration), &written_}, kRealType, kTimeUnit,
                           fmt::format("the time of `{}`", description_.name), scope_.diagnostics);
      if (!duration) return std::nullopt;
    }
    if (Least(*duration) < 0) return Wrong(duration->span, "a length of time is never negative");
    return duration;
  }

  // How many values a delay of this length has to remember, besides the present one.
  std::optional<uint32_t> StepsOf(const CheckedExpression& duration, uint32_t size) {
    double steps = Most(duration);
    if (std::isinf(steps)) {
      Wrong(duration.span, "nothing says how long this delay can become");
      return std::nullopt;
    }
    if (duration.type.scalar == Scalar::kReal) {
      if (std::isinf(task_.longest_time_step)) {
        Report(scope_.diagnostics, code::kBadDuration, duration.span,
               "without a robot it is not known how many time steps this is",
               {.help = "write the number of time steps: `delay(x, 3)`"});
        return std::nullopt;
      }
      steps = std::ceil(steps / task_.longest_time_step - 1e-9);
    }
    if ((steps + 1) * size <= kLongestPast) return static_cast<uint32_t>(steps) + 1;
    Report(scope_.diagnostics, code::kBadDuration, duration.span, "this delay is too long",
           {.note = fmt::format("it would remember {:.0f} values, and at most {} fit",
                                (steps + 1) * size, kLongestPast)});
    return std::nullopt;
  }

 private:
  double Least(const CheckedExpression& duration) const {
    const auto* param = std::get_if<ParamRead>(&duration.node);
    return param != nullptr ? task_.params[param->param].minimum : *ValueOf(duration);
  }
  double Most(const CheckedExpression& duration) const {
    const auto* param = std::get_if<ParamRead>(&duration.node);
    return param != nullptr ? task_.params[param->param].maximum : *ValueOf(duration);
  }
  std::nullopt_t Wrong(Span span, std::string message) {
    Report(scope_.diagnostics, code::kBadDuration, span, std::move(message),
           {.help = "write a time such as `0.2 s`, or a param with a range: `param lag: real [s] = "
                    "0.2 s in 0 s .. 1 s`"});
    return std::nullopt;
  }

  const TimeFunctionDescription& description_;
  const Expression& written_;
  const CheckedTask& task_;
  const TaskScope& scope_;
};

// They count from the start of the episode, where their memory is reset.
bool CountsTime(TimeFunction function) {
  return function == TimeFunction::kHeld || function == TimeFunction::kSince;
}

}  // namespace

const TimeFunctionDescription* FindTimeFunction(std::string_view name) {
  const auto* found = std::ranges::find(kTimeFunctions, name, &TimeFunctionDescription::name);
  return found == std::end(kTimeFunctions) ? nullptr : found;
}

std::string_view NameOf(TimeFunction function) {
  return std::ranges::find(kTimeFunctions, function, &TimeFunctionDescription::function)->name;
}

std::optional<CheckedExpression> TimeFunctionTable::Check(
    const TimeFunctionDescription& description, const CallExpression& call, Span span,
    const Place& place, const TaskScope& scope) {
  if (Misplaced(description, place, span, scope)) return std::nullopt;
  if (!CheckCount(description, call, span, scope)) return std::nullopt;
  auto value = CheckExpression(*call.arguments[0], {Place::kTimed}, scope);
  if (!value || !CheckArgument(description, *value, scope)) return std::nullopt;
  const bool needs_reals =
      description.function == TimeFunction::kRate || description.function == TimeFunction::kSmooth;
  if (needs_reals) value = ToReal(std::move(*value));
  std::optional<CheckedExpression> duration;
  uint32_t steps = 1;
  if (description.takes_duration) {
    DurationCheck check(description, *call.arguments[1], task_, scope);
    duration = check.Check();
    if (!duration) return std::nullopt;
    if (description.function == TimeFunction::kDelay) {
      const auto found = check.StepsOf(*duration, value->type.size());
      if (!found) return std::nullopt;
      steps = *found;
    }
  }
  auto index = FindSame(description.function, *value, duration);
  if (!index) index = Add(description, std::move(*value), std::move(duration), steps, span);
  const uint32_t memory = task_.time_functions[*index].value;
  return CheckedExpression{span, task_.memory[memory].type, task_.memory[memory].unit,
                           MemoryRead{memory}};
}

std::optional<uint32_t> TimeFunctionTable::FindSame(
    TimeFunction function, const CheckedExpression& argument,
    const std::optional<CheckedExpression>& duration) const {
  for (uint32_t i = 0; i < arguments_.size(); ++i) {
    const Arguments& known = arguments_[i];
    if (task_.time_functions[i].function != function || !IsSame(known.value, argument)) continue;
    if (!duration || IsSame(*known.duration, *duration)) return i;
  }
  return std::nullopt;
}

uint32_t TimeFunctionTable::Add(const TimeFunctionDescription& description,
                                CheckedExpression argument,
                                std::optional<CheckedExpression> duration, uint32_t steps,
                                Span span) {
  const auto index = static_cast<uint32_t>(task_.time_functions.size());
  const std::string name = fmt::format("{}#{}", description.name, index + 1);
  const Result result = ResultOf(description.function, argument);
  CheckedTimeFunction added{.function = description.function, .steps = steps, .span = span};
  added.value = AddMemory(name, result.type, result.unit, span);
  if (description.function != TimeFunction::kSince) {
    Result past = PastOf(description.function, argument);
    if (description.function == TimeFunction::kDelay) {
      past.type = {past.type.scalar, Shape::kArray, steps * past.type.size(), 1, ""};
      added.next = AddMemory(name + "#next", ScalarType(Scalar::kInt), {}, span);
    }
    added.past = AddMemory(name + "#past", past.type, past.unit, span);
  }
  task_.time_functions.push_back(added);
  arguments_.push_back({std::move(argument), std::move(duration)});
  return index;
}

uint32_t TimeFunctionTable::AddMemory(std::string name, const Type& type, Unit unit, Span span) {
  return AddHiddenMemory(std::move(name), type, unit, MemoryScope::kPerEpisode, span, task_);
}

void TimeFunctionTable::AddStatements() {
  for (const EventKind event : {EventKind::kStartOfEpisode, EventKind::kEndOfTimeStep}) {
    const bool is_start = event == EventKind::kStartOfEpisode;
    CheckedBlock advances;
    for (uint32_t i = 0; i < arguments_.size(); ++i) {
      const CheckedTimeFunction& function = task_.time_functions[i];
      if (is_start && CountsTime(function.function)) continue;
      const auto& [value, duration] = arguments_[i];
      CheckedAdvance advance{i, is_start, CopyOf(value), {}};
      if (duration && !is_start) advance.duration = CopyOf(*duration);
      advances.push_back({function.span, std::move(advance)});
    }
    CheckedBlock& body = task_.events[static_cast<size_t>(event)].body;
    std::ranges::move(body, std::back_inserter(advances));
    body = std::move(advances);
  }
}

}  // namespace compiler
