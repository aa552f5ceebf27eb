#include "compiler/task_tests/find_fault.h"

#include <algorithm>

#include "compiler/interpret/evaluator.h"
#include "compiler/source/diagnostic.h"
#include "compiler/task_tests/value_text.h"

namespace compiler {
namespace {

// `entries`: of the task, each with its type.
template <class Entry>
void Fill(const std::vector<Entry>& entries, const std::vector<std::vector<double>>& numbers,
          std::vector<Value>& values) {
  bool fits = entries.size() == numbers.size();
  for (size_t i = 0; fits && i < entries.size(); ++i) {
    fits = entries[i].type.size() == numbers[i].size();
    if (fits) values[i] = MakeValue(entries[i].type.scalar, numbers[i]);
  }
  if (!fits) throw CallError("the situation is one of another task");
}

ValueOfPart PartOf(const CheckedExpression& expression, const Value& value) {
  return {expression.span, ToString(value, expression.type, expression.unit)};
}

}  // namespace

std::optional<FoundFault> FindFault(const CheckedTask& task, const FaultySituation& situation) {
  Evaluator evaluator(task);
  Frame& frame = evaluator.frame();
  Fill(task.sensors, situation.sensors, frame.sensors);
  Fill(task.memory, situation.memory, frame.memory);
  if (situation.params.size() != frame.params.size() || situation.term >= task.terms.size()) {
    throw CallError("the situation is one of another task");
  }
  frame.params = situation.params;
  frame.seed = situation.seed;
  frame.discount = situation.discount;
  frame.outcome = situation.outcome;
  evaluator.Watch(situation.term);
  evaluator.Fire(situation.event, situation.time_step);
  if (!evaluator.blame()) return std::nullopt;
  FoundFault found{PartOf(*evaluator.blame()->expression, evaluator.blame()->value), {}};
  for (const BlamedOperand& operand : evaluator.blame()->operands) {
    const bool is_known = std::ranges::any_of(found.operands, [&](const ValueOfPart& each) {
      return each.span.begin == operand.expression->span.begin;
    });
    if (!is_known) found.operands.push_back(PartOf(*operand.expression, operand.value));
  }
  return found;
}

}  // namespace compiler
