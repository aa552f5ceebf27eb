#include "compiler/task_tests/expectation.h"

#include <fmt/format.h>

#include "compiler/task_tests/value_text.h"

namespace compiler {
namespace {

bool IsComparison(BinaryOperator op) {
  return op >= BinaryOperator::kLess && op <= BinaryOperator::kNotEqual;
}

void AddValue(const CheckedExpression& part, const Evaluator& evaluator,
              std::vector<SeenValue>& seen) {
  if (const auto* conversion = std::get_if<IntToReal>(&part.node)) {
    return AddValue(*conversion->operand, evaluator, seen);
  }
  if (std::holds_alternative<Constant>(part.node)) return;
  seen.push_back({part.span, ToString(evaluator.Evaluate(part), part.type, part.unit)});
}

void AddReasons(const CheckedExpression& condition, const Evaluator& evaluator,
                std::vector<SeenValue>& seen) {
  if (IsTrue(evaluator.Evaluate(condition))) return;
  const auto* binary = std::get_if<CheckedBinary>(&condition.node);
  if (binary == nullptr) return;
  if (IsComparison(binary->op)) {
    AddValue(*binary->left, evaluator, seen);
    AddValue(*binary->right, evaluator, seen);
  } else {
    AddReasons(*binary->left, evaluator, seen);
    AddReasons(*binary->right, evaluator, seen);
  }
}

}  // namespace

std::vector<SeenValue> Explain(const CheckedExpression& condition, const Evaluator& evaluator) {
  std::vector<SeenValue> seen;
  AddReasons(condition, evaluator, seen);
  return seen;
}

}  // namespace compiler
