#include "compiler/check/sensor_use.h"

#include <taskc/plugin.h>

#include <set>
#include <utility>
#include <vector>

#include "compiler/check/report.h"
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
  for (CheckedObservation& observation : task.observations)
    visit_all(observation.value, TASKC_OBSERVE);
}

// The sensors that an `expect` reads, with what is called for each of them.
template <typename Visit>
void ForEachExpectedRead(CheckedTask& task, const Visit& visit) {
  for (CheckedTest& test : task.tests)
    for (CheckedTestStatement& statement : test.statements)
      if (auto* expect = std::get_if<CheckedExpect>(&statement.node))
        ForEachPart(expect->condition, [&](CheckedExpression& part) {
          if (auto* read = std::get_if<SensorRead>(&part.node)) visit(*read, part.span);
        });
}

// The sensor that a statement of a test gives, or null.
CheckedGiven* GivenSensor(CheckedTestStatement& statement) {
  auto* given = std::get_if<CheckedGiven>(&statement.node);
  return given != nullptr && given->target == CheckedGiven::kSensor ? given : nullptr;
}

// What a test says of a sensor that nothing reads: an expectation says nothing of the task, and
// what is given has no effect.
void CheckTestedSensors(CheckedTask& task, Diagnostics& diagnostics) {
  ForEachExpectedRead(task, [&](const SensorRead& read, Span span) {
    const CheckedSensor& sensor = task.sensors[read.sensor];
    if (sensor.read_by != 0) return;
    Report(diagnostics, code::kUnreadSensor, span,
           fmt::format("nothing in this task reads `{}`", sensor.name),
           {.note = "it only has the value that the test itself gives it"});
  });
  if (diagnostics.has_errors()) return;
  const auto is_read = [&](const CheckedGiven& given) {
    return task.sensors[given.index].read_by != 0;
  };
  // Where the statements begin that have an effect, perhaps only by what they imply.
  std::set<uint32_t> effective;
  for (CheckedTest& test : task.tests)
    for (CheckedTestStatement& statement : test.statements)
      if (const CheckedGiven* given = GivenSensor(statement); given != nullptr && is_read(*given))
        effective.insert(statement.span.begin);
  const auto is_useless = [&](CheckedTestStatement& statement) {
    const CheckedGiven* given = GivenSensor(statement);
    if (given == nullptr || is_read(*given)) return false;
    if (!given->is_implied && !effective.contains(statement.span.begin))
      Report(diagnostics, code::kUselessGiven, statement.span,
             fmt::format("nothing in this task reads `{}`", task.sensors[given->index].name));
    return true;
  };
  for (CheckedTest& test : task.tests) std::erase_if(test.statements, is_useless);
}

}  // namespace

void KeepReadSensors(CheckedTask& task, Diagnostics& diagnostics) {
  ForEachRead(task, [&](SensorRead& read, uint32_t bit) {
    task.sensors[read.sensor].read_by |= 1u << bit;
  });
  CheckTestedSensors(task, diagnostics);
  std::vector<uint32_t> new_index(task.sensors.size());
  std::vector<CheckedSensor> kept;
  for (size_t i = 0; i < task.sensors.size(); ++i) {
    new_index[i] = static_cast<uint32_t>(kept.size());
    if (task.sensors[i].read_by != 0) kept.push_back(std::move(task.sensors[i]));
  }
  task.sensors = std::move(kept);
  const auto rename = [&](SensorRead& read, auto) { read.sensor = new_index[read.sensor]; };
  ForEachRead(task, rename);
  ForEachExpectedRead(task, rename);
  for (CheckedTest& test : task.tests)
    for (CheckedTestStatement& statement : test.statements)
      if (CheckedGiven* given = GivenSensor(statement)) given->index = new_index[given->index];
}

}  // namespace compiler
