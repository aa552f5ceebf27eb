#include "compiler/emit/used_values.h"

#include "base/variant/overloaded.h"
#include "compiler/check/traversal.h"

namespace compiler {

bool Reads(const CheckedExpression& expression, uint32_t memory) {
  bool reads = false;
  ForEachPart(expression, [&](const CheckedExpression& part) {
    const auto* read = std::get_if<MemoryRead>(&part.node);
    reads = reads || (read != nullptr && read->memory == memory);
  });
  return reads;
}

void UsedValues::Add(const CheckedExpression& expression) {
  size.Add(expression);
  ForEachPart(expression, [this](const CheckedExpression& part) {
    std::visit(variant::Overloaded{
                   [&](const ConstRead& node) { consts.insert(node.index); },
                   [&](const TableRead& node) { tables.insert(node.table); },
                   [&](const SensorRead& node) {
                     sensors.insert(node.sensor);
                     frame = true;
                   },
                   [&](const ParamRead& node) {
                     params.insert(node.param);
                     frame = true;
                   },
                   [&](const MemoryRead&) { memory = frame = true; },
                   [&](const RewardSoFar&) { reward = frame = true; },
                   [&](const TimeStep&) { frame = true; },
                   [&](const Draw&) { draws = frame = true; },
                   [&](const LocalRead& node) { locals.insert(node.local); },
                   [&](const ArgumentRead& node) { arguments.insert(node.argument); },
                   [](const auto&) {},
               },
               part.node);
  });
}

void UsedValues::Add(const CheckedBlock& block) {
  ForEachStatement(block, [this](const CheckedStatement& statement) {
    size.AddStatement();
    std::visit(
        variant::Overloaded{
            [](const CheckedLet&) {},
            [](const CheckedIf&) {},
            [](const CheckedFor&) {},
            [this](const variant::OneOf<CheckedAssign, CheckedAdvance, CheckedPhaseSwitch> auto&) {
              memory = frame = true;
            },
            [this](const CheckedReward&) { reward = frame = true; },
            [this](const CheckedPotentialStep& step) {
              memory = frame = true;
              reward = reward || step.moment != CheckedPotentialStep::kStart;
            },
            [this](const auto&) { frame = true; },
        },
        statement.node);
    ForEachExpression(statement, [this](const CheckedExpression& value) { Add(value); });
  });
}

void UsedValues::AddStatement(const CheckedExpression& value) {
  size.AddStatement();
  Add(value);
}

void UsedValues::AddReset(const CheckedMemory& variable) {
  memory = frame = true;
  AddStatement(variable.initial);
}

UsedValues UsedBy(const CheckedTask& task) {
  UsedValues used;
  for (const CheckedEvent& event : task.events) used.Add(event.body);
  used.Add(task.start.block.body);
  for (const CheckedMetric& metric : task.metrics) used.Add(metric.value);
  for (const CheckedObservation& observation : task.observations) used.Add(observation.value);
  for (const CheckedGoal& goal : task.goals) {
    used.Add(goal.value);
    if (goal.interval) used.Add(goal.interval->length);
  }
  for (const CheckedFunction& function : task.functions) {
    for (const CheckedLet& let : function.lets) used.Add(let.value);
    used.Add(function.value);
  }
  return used;
}

}  // namespace compiler
