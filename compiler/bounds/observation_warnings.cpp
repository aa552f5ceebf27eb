#include "compiler/bounds/observation_warnings.h"

#include <set>
#include <utility>

#include "compiler/bounds/bounds_text.h"
#include "compiler/bounds/dependence.h"
#include "compiler/check/report.h"
#include "compiler/check/traversal.h"

namespace compiler {
namespace {

// A sensor that the value of an observation depends on and that is not onboard, or null.
const CheckedSensor* FindUnsensed(const CheckedTask& task, const Dependence& dependence,
                                  const CheckedExpression& value) {
  std::set<uint32_t> sensors;
  std::set<uint32_t> memory;
  ForEachPart(value, [&](const CheckedExpression& part) {
    if (const auto* read = std::get_if<SensorRead>(&part.node)) sensors.insert(read->sensor);
    if (const auto* read = std::get_if<MemoryRead>(&part.node)) memory.insert(read->memory);
  });
  for (const uint32_t source : WithSources(dependence, std::move(memory)))
    sensors.insert(dependence.sensors[source].begin(), dependence.sensors[source].end());
  for (const uint32_t sensor : sensors)
    if (!task.sensors[sensor].is_onboard) return &task.sensors[sensor];
  return nullptr;
}

// What is inherited is spoken of where the task says that the robot has to sense it.
void WarnOfUnsensed(const CheckedTask& task, const Sources& sources, Diagnostics& diagnostics) {
  const Dependence dependence = DependenceOf(task);
  for (const CheckedObservation& observation : task.observations) {
    const CheckedSensor* sensor = FindUnsensed(task, dependence, observation.value);
    if (sensor == nullptr) continue;
    if (sources.IndexOf(observation.value.span) == 0) {
      Report(diagnostics, code::kNotOnboard, observation.value.span,
             fmt::format("a real robot cannot sense this: it depends on `{}`", sensor->name),
             {.labels = {{*task.onboard, "its own sensors are to be enough"}}});
    } else {
      Report(diagnostics, code::kNotOnboard, *task.onboard,
             fmt::format("a real robot cannot sense `{}`, which an inherited observation shows",
                         sensor->name),
             {.labels = {{observation.value.span, "observed here"}}});
    }
  }
}

}  // namespace

void WarnOfObservations(const CheckedTask& task, const Sources& sources, const TaskBounds& bounds,
                        Diagnostics& diagnostics) {
  for (size_t i = 0; i < task.observations.size(); ++i) {
    const Interval& value = bounds.observations[i].value;
    if (!IsExact(value)) continue;
    Report(diagnostics, code::kConstantObservation, task.observations[i].value.span,
           fmt::format("the learner always sees the same here: {}",
                       RangeText(value, task.observations[i].value.unit)));
  }
  if (task.onboard) WarnOfUnsensed(task, sources, diagnostics);
}

}  // namespace compiler
