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
  ForEachPart(expression, [this](const CheckedExpression& part) {
    std::visit(variant::Overloaded{
                   [this](const SensorRead& node) { sensors.insert(node.sensor); },
                   [this](const ParamRead& node) { params.insert(node.param); },
                   [this](const MemoryRead&) { memory = true; },
                   [this](const RewardSoFar&) { reward = true; },
                   [](const auto&) {},
               },
               part.node);
  });
}

void UsedValues::Add(const CheckedBlock& block) {
  ForEachStatement(block, [this](const CheckedStatement& statement) {
    if (std::holds_alternative<CheckedAssign>(statement.node)) memory = true;
    if (std::holds_alternative<CheckedReward>(statement.node)) reward = true;
    ForEachExpression(statement, [this](const CheckedExpression& value) { Add(value); });
  });
}

}  // namespace compiler
