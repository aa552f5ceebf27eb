#include "compiler/check/real_equality.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "compiler/check/fold.h"
#include "compiler/check/report.h"
#include "compiler/check/traversal.h"

namespace compiler {
namespace {

// These give one of a few values, so that equality with one of them makes sense.
bool IsDiscrete(const CheckedExpression& expression) {
  const auto* call = std::get_if<BuiltinCall>(&expression.node);
  if (call == nullptr) return false;
  constexpr Builtin kDiscrete[] = {Builtin::kSign,  Builtin::kFloor, Builtin::kCeil,
                                   Builtin::kRound, Builtin::kClamp, Builtin::kMin,
                                   Builtin::kMax,   Builtin::kSelect};
  return std::ranges::find(kDiscrete, call->function) != std::end(kDiscrete);
}

class EqualitySearch {
 public:
  EqualitySearch(const CheckedTask& task, Diagnostics& diagnostics)
      : task_(task), diagnostics_(diagnostics) {}

  void Search() {
    for (const CheckedFunction& function : task_.functions) {
      measured_locals_.clear();
      for (const CheckedLet& let : function.lets) Look(let);
      Look(function.value);
    }
    for (const CheckedMetric& metric : task_.metrics) Look(metric.value);
    for (const CheckedObservation& observation : task_.observations) Look(observation.value);
    for (const CheckedEvent& event : task_.events) {
      measured_locals_.clear();
      ForEachStatement(event.body, [&](const CheckedStatement& statement) {
        if (const auto* let = std::get_if<CheckedLet>(&statement.node)) return Look(*let);
        ForEachExpression(statement, [&](const CheckedExpression& value) { Look(value); });
      });
    }
  }

 private:
  void Look(const CheckedLet& let) {
    Look(let.value);
    if (IsMeasured(let.value)) measured_locals_.insert(let.local);
  }

  void Look(const CheckedExpression& expression) {
    ForEachPart(expression, [&](const CheckedExpression& part) {
      const auto* binary = std::get_if<CheckedBinary>(&part.node);
      if (binary != nullptr) Look(*binary, part.span);
    });
  }

  void Look(const CheckedBinary& binary, Span span) {
    const bool asks_for_equality =
        binary.op == BinaryOperator::kEqual || binary.op == BinaryOperator::kNotEqual;
    if (!asks_for_equality || binary.left->type.scalar != Scalar::kReal) return;
    if (!IsMeasured(*binary.left) && !IsMeasured(*binary.right)) return;
    const bool is_different = binary.op == BinaryOperator::kNotEqual;
    // `x != 0`, before something is divided by x, is no such mistake.
    if (is_different && (ValueOf(*binary.left) == 0 || ValueOf(*binary.right) == 0)) return;
    if (!said_.insert(span.begin).second) return;
    const std::string unit = ToString(binary.left->unit);
    Report(diagnostics_, code::kRealEquality, span,
           is_different ? "two real numbers are nearly always different"
                        : "two real numbers are hardly ever equal",
           {.help = fmt::format("say how far they may differ: `abs(x - y) {} 0.01{}`",
                                is_different ? ">" : "<", unit.empty() ? "" : " " + unit)});
  }

  // Does its value come from real numbers that were measured, or that a function was given?
  bool IsMeasured(const CheckedExpression& expression) const {
    if (IsDiscrete(expression)) return false;
    bool is_measured = false;
    ForEachPart(expression, [&](const CheckedExpression& part) {
      const auto* local = std::get_if<LocalRead>(&part.node);
      const bool is_real = part.type.scalar == Scalar::kReal;
      const bool is_read = std::holds_alternative<SensorRead>(part.node) ||
                           std::holds_alternative<ArgumentRead>(part.node) ||
                           std::holds_alternative<TimeStep>(part.node) ||
                           (local != nullptr && measured_locals_.contains(local->local));
      if (is_real && is_read) is_measured = true;
    });
    return is_measured;
  }

  const CheckedTask& task_;
  Diagnostics& diagnostics_;
  std::set<uint32_t> measured_locals_;  // of the event or function that is looked at
  std::set<uint32_t> said_;             // where those begin that were warned of
};

}  // namespace

void WarnOfRealEquality(const CheckedTask& task, Diagnostics& diagnostics) {
  EqualitySearch(task, diagnostics).Search();
}

}  // namespace compiler
