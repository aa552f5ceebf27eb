#include "compiler/task_tests/expectation.h"

#include <cctype>
#include <cmath>
#include <string_view>

#include "compiler/check/unit.h"
#include "compiler/task_tests/value_text.h"

namespace compiler {
namespace {

bool IsComparison(BinaryOperator op) {
  return op >= BinaryOperator::kLess && op <= BinaryOperator::kNotEqual;
}

bool IsWordCharacter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// Does the text of a constant name one, rather than only units, `true` or `false`?
bool HasName(std::string_view text) {
  for (size_t begin = 0; begin < text.size();) {
    size_t end = begin;
    while (end < text.size() && IsWordCharacter(text[end])) ++end;
    const std::string_view word = text.substr(begin, end - begin);
    const bool is_name = !word.empty() && std::isdigit(static_cast<unsigned char>(word[0])) == 0;
    if (is_name && !FindUnit(std::string(word)) && word != "true" && word != "false") return true;
    begin = end + 1;
  }
  return false;
}

class Explainer {
 public:
  Explainer(const CheckedTask& task, const Evaluator& evaluator, const Sources& sources)
      : task_(task), evaluator_(evaluator), sources_(sources) {}

  std::vector<SeenValue> Explain(const CheckedExpression& condition) {
    AddReasons(condition);
    return std::move(seen_);
  }

 private:
  void AddReasons(const CheckedExpression& condition) {
    if (IsTrue(evaluator_.Evaluate(condition))) return;
    if (const auto* within = std::get_if<CheckedWithin>(&condition.node))
      return AddDifference(*within, condition.span);
    const auto* binary = std::get_if<CheckedBinary>(&condition.node);
    if (binary == nullptr) return;
    if (IsPresentPhase(*binary->left)) {
      AddPhase(*binary->left);
    } else if (IsComparison(binary->op)) {
      AddValue(*binary->left);
      AddValue(*binary->right);
    } else {
      AddReasons(*binary->left);
      AddReasons(*binary->right);
    }
  }

  bool IsPresentPhase(const CheckedExpression& part) const {
    const auto* read = std::get_if<MemoryRead>(&part.node);
    return read != nullptr && !task_.phases.empty() && read->memory == task_.phase_memory.present;
  }

  void AddPhase(const CheckedExpression& present) {
    const auto phase = static_cast<size_t>(RealOf(evaluator_.Evaluate(present)));
    seen_.push_back({present.span, task_.phases[phase].name});
  }

  void AddDifference(const CheckedWithin& within, Span span) {
    AddValue(*within.left);
    AddValue(*within.right);
    AddValue(*within.tolerance);
    const double left = RealOf(evaluator_.Evaluate(*within.left));
    const double right = RealOf(evaluator_.Evaluate(*within.right));
    const Reals difference{std::abs(left - right)};
    seen_.push_back(
        {span, ToString(difference, within.left->type, within.left->unit), "the difference"});
  }

  void AddValue(const CheckedExpression& part) {
    if (const auto* conversion = std::get_if<IntToReal>(&part.node))
      return AddValue(*conversion->operand);
    const bool is_constant = std::holds_alternative<Constant>(part.node);
    if (is_constant && !HasName(sources_.FileOf(part.span).TextOf(part.span))) return;
    seen_.push_back({part.span, ToString(evaluator_.Evaluate(part), part.type, part.unit)});
  }

  const CheckedTask& task_;
  const Evaluator& evaluator_;
  const Sources& sources_;
  std::vector<SeenValue> seen_;
};

}  // namespace

std::vector<SeenValue> Explain(const CheckedExpression& condition, const CheckedTask& task,
                               const Evaluator& evaluator, const Sources& sources) {
  return Explainer(task, evaluator, sources).Explain(condition);
}

}  // namespace compiler
