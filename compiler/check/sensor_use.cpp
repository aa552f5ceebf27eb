#include "compiler/check/sensor_use.h"

#include <taskc/plugin.h>

#include <utility>
#include <vector>

#include "compiler/check/traversal.h"

namespace compiler {
namespace {

// Calls `visit(read, bit)` for every sensor read of the task, with the bit number of its place.
template <typename Visit>
void ForEachRead(CheckedTask& task, const Visit& visit) {
  const auto visit_all = [&](CheckedExpression& expression, uint32_t bit) {
    ForEachPart(expression, [&](CheckedExpression& part) {
      if (auto* read = std::get_if<SensorRead>(&part.node)) visit(*read, bit);
    });
  };
  for (uint32_t event = 0; event < task.events.size(); ++event)
    ForEachStatement(task.events[event].body, [&](CheckedStatement& statement) {
      ForEachExpression(statement,
                        [&](CheckedExpression& expression) { visit_all(expression, event); });
    });
  for (CheckedMetric& metric : task.metrics) visit_all(metric.value, TASKC_MEASURE);
}

}  // namespace

void KeepReadSensors(CheckedTask& task) {
  ForEachRead(task, [&](SensorRead& read, uint32_t bit) {
    task.sensors[read.sensor].read_by |= 1u << bit;
  });
  std::vector<uint32_t> new_index(task.sensors.size());
  std::vector<CheckedSensor> kept;
  for (size_t i = 0; i < task.sensors.size(); ++i) {
    new_index[i] = static_cast<uint32_t>(kept.size());
    if (task.sensors[i].read_by != 0) kept.push_back(std::move(task.sensors[i]));
  }
  task.sensors = std::move(kept);
  ForEachRead(task, [&](SensorRead& read, uint32_t) { read.sensor = new_index[read.sensor]; });
}

}  // namespace compiler
