#include "compiler/bounds/bounds.h"

#include "compiler/bounds/causes.h"
#include "compiler/bounds/domains.h"
#include "compiler/bounds/event_bounds.h"
#include "compiler/bounds/expression_bounds.h"
#include "compiler/bounds/memory_bounds.h"

namespace compiler {
namespace {

// A metric is measured after a time step, of whatever length.
ValueBounds MetricBounds(const CheckedTask& task, const CheckedMetric& metric,
                         const Assumptions& assumptions, TaskBounds& found) {
  Values values = ValuesAtStart(task, EventKind::kEndOfTimeStep, assumptions);
  values.memory = found.memory;
  FindLeftDomains(task, values, {}, metric.value, found.left_domains);
  return {ExpressionBounds(task, values).Of(metric.value),
          CausesOf(task, values, {}, metric.value)};
}

// What the learner sees when it decides, in between two time steps.
ValueBounds ObservationBounds(const CheckedTask& task, const CheckedObservation& observation,
                              const Assumptions& assumptions, TaskBounds& found) {
  Values values = ValuesAtStart(task, EventKind::kEndOfAction, assumptions);
  values.memory = found.memory;
  FindLeftDomains(task, values, {}, observation.value, found.left_domains);
  return {Hull(ExpressionBounds(task, values).AllOf(observation.value)),
          CausesOf(task, values, {}, observation.value)};
}

}  // namespace

Interval PaymentOfPotential(const Interval& potential) {
  const Interval reached = Calculate(BinaryOperator::kMultiply, {0, 1}, potential, Scalar::kReal);
  return Calculate(BinaryOperator::kSubtract, reached, potential, Scalar::kReal);
}

TaskBounds ComputeBounds(const CheckedTask& task, const Assumptions& assumptions) {
  TaskBounds bounds;
  bounds.terms.resize(task.terms.size());
  bounds.logs.resize(task.logs.size());
  bounds.ends_reached.resize(task.ends.size());
  bounds.memory = MemoryBounds(task, assumptions);
  EventBounds events(task, &bounds);
  for (size_t i = 0; i < task.events.size(); ++i) {
    Values values = ValuesAtStart(task, static_cast<EventKind>(i), assumptions);
    values.memory = bounds.memory;
    events.Run(task.events[i], std::move(values));
  }
  for (const CheckedMetric& metric : task.metrics)
    bounds.metrics.push_back(MetricBounds(task, metric, assumptions, bounds));
  for (const CheckedObservation& observation : task.observations)
    bounds.observations.push_back(ObservationBounds(task, observation, assumptions, bounds));
  return bounds;
}

}  // namespace compiler
