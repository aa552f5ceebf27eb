#include "compiler/task_tests/side_by_side.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "compiler/syntax/words.h"
#include "plugins/host/log_value.h"

namespace compiler {
namespace {

bool IsSame(int64_t a, int64_t b) { return a == b; }
bool IsSame(double a, double b) {
  return std::bit_cast<uint64_t>(a) == std::bit_cast<uint64_t>(b) ||
         (std::isnan(a) && std::isnan(b));
}

template <typename Number>
void CompareNumbers(const std::string& what, Number plugin, Number evaluator) {
  if (IsSame(plugin, evaluator)) return;
  throw Disagreement(
      fmt::format("{} is {} in the plugin and {} in the evaluator", what, plugin, evaluator));
}

void CompareValues(const std::string& what, const Value& plugin, const Value& evaluator) {
  std::visit(
      [&]<typename ElementsType>(const ElementsType& elements) {
        const auto& others = std::get<ElementsType>(evaluator);
        for (size_t i = 0; i < elements.size(); ++i) {
          CompareNumbers(fmt::format("{}[{}]", what, i), elements[i], others[i]);
        }
      },
      plugin);
}

void CompareIndices(const std::string& what, int32_t plugin, int32_t evaluator) {
  CompareNumbers<int64_t>("the index of the " + what, plugin, evaluator);
}

}  // namespace

SideBySide::SideBySide(const CheckedTask& task, const taskc_plugin& plugin)
    : task_(task),
      plugin_(plugin),
      reducer_({plugin.metrics, plugin.metric_count}),
      evaluator_(task) {
  Compare();
  Record();
}

void SideBySide::SetSensor(uint32_t sensor, const Value& value) {
  plugin_.SetSensor(sensor, value);
  evaluator_.frame().sensors[sensor] = value;
}

void SideBySide::SetParam(uint32_t param, double value) {
  plugin_.SetParam(param, value);
  evaluator_.frame().params[param] = value;
}

void SideBySide::SetMemory(uint32_t memory, const Value& value) {
  plugin_.SetMemory(memory, value);
  evaluator_.frame().memory[memory] = value;
}

void SideBySide::SetSeed(uint64_t seed) {
  plugin_.SetSeed(seed);
  evaluator_.frame().seed = seed;
}

void SideBySide::DrawStart(uint32_t attempt) {
  evaluator_.frame().attempt = attempt;
  evaluator_.DrawPose();
  CompareIndices("pose", plugin_.DrawPose(), evaluator_.frame().pose);
  plugin_.DrawStart(attempt);
  evaluator_.DrawStart();
  for (size_t i = 0; i < task_.memory.size(); ++i) CompareMemory(i);
}

void SideBySide::SetDiscount(double discount) {
  plugin_.SetDiscount(discount);
  evaluator_.frame().discount = discount;
}

// As a trainer understands it: a requirement that does not hold comes before an end.
void SideBySide::NoteEnd() {
  const Frame& frame = evaluator_.frame();
  if (outcome_ || (frame.end < 0 && frame.violation < 0)) return;
  outcome_ =
      frame.violation >= 0 ? EndKind::kTruncated : task_.ends[static_cast<size_t>(frame.end)].kind;
}

void SideBySide::Fire(EventKind event, double time_step) {
  evaluator_.frame().outcome = outcome_.value_or(EndKind::kTruncated);
  plugin_.SetOutcome(static_cast<int>(evaluator_.frame().outcome));
  plugin_.Fire(static_cast<int>(event), time_step);
  plugin_.Measure();
  plugin_.Observe();
  evaluator_.Fire(event, time_step);
  evaluator_.Measure();
  evaluator_.Observe();
  try {
    Compare();
  } catch (const Disagreement& found) {
    throw Disagreement(fmt::format("after `{}`, {}", NameOf(event, kEventNames), found.what()));
  }
  NoteEnd();
  if (event == EventKind::kEndOfTimeStep) reducer_.EndTimeStep(evaluator_.frame().metrics);
}

void SideBySide::Record() {
  Frame& frame = evaluator_.frame();
  host::MetricReducer episode = reducer_;
  episode.EndEpisode(frame.metrics);
  frame.recorded_metrics.assign(episode.values().begin(), episode.values().end());
  frame.recorded_logs.clear();
  for (size_t i = 0; i < task_.logs.size(); ++i)
    frame.recorded_logs.push_back(
        host::LogValue(plugin_.table().logs[i].reduction, plugin_.frame().logs[i]));
}

void SideBySide::Compare() const {
  const taskc_frame& plugin = plugin_.frame();
  const Frame& evaluator = evaluator_.frame();
  CompareNumbers("the reward", plugin.reward, evaluator.reward);
  CompareIndices("end", plugin.end, evaluator.end);
  CompareIndices("fault", plugin.fault, evaluator.fault);
  CompareIndices("violation", plugin.violation, evaluator.violation);
  for (size_t i = 0; i < task_.terms.size(); ++i) {
    CompareNumbers(fmt::format("term `{}`", task_.terms[i].name), plugin.terms[i],
                   evaluator.terms[i]);
  }
  for (size_t i = 0; i < task_.memory.size(); ++i) CompareMemory(i);
  for (size_t i = 0; i < task_.metrics.size(); ++i) {
    CompareNumbers(fmt::format("metric `{}`", task_.metrics[i].name), plugin.metrics[i],
                   evaluator.metrics[i]);
  }
  for (const CheckedObservation& observation : task_.observations) {
    for (uint32_t i = 0; i < observation.value.type.size(); ++i) {
      const uint32_t place = observation.offset + i;
      CompareNumbers(fmt::format("observation `{}`[{}]", observation.name, i),
                     plugin.observations[place], evaluator.observations[place]);
    }
  }
  CompareLogs();
}

void SideBySide::CompareMemory(size_t memory) const {
  CompareValues(fmt::format("memory `{}`", task_.memory[memory].name), plugin_.Memory(memory),
                evaluator_.frame().memory[memory]);
}

void SideBySide::CompareLogs() const {
  for (size_t i = 0; i < task_.logs.size(); ++i) {
    const taskc_log_state& plugin = plugin_.frame().logs[i];
    const LogState& evaluator = evaluator_.frame().logs[i];
    const std::string name = fmt::format("of log `{}`", task_.logs[i].name);
    CompareNumbers<int64_t>("the count " + name, plugin.count, evaluator.count);
    if (plugin.count == 0) continue;
    CompareNumbers("the last value " + name, plugin.last, evaluator.last);
    CompareNumbers("the sum " + name, plugin.sum, evaluator.sum);
    CompareNumbers("the minimum " + name, plugin.minimum, evaluator.minimum);
    CompareNumbers("the maximum " + name, plugin.maximum, evaluator.maximum);
  }
}

}  // namespace compiler
