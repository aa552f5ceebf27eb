#include "compiler/bounds/causes.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "compiler/bounds/expression_bounds.h"
#include "compiler/check/builtins.h"

namespace compiler {
namespace {

std::string NameOf(std::variant<Builtin, Composite> function) {
  for (const std::string& name : BuiltinNames())
    if (FindBuiltin(name)->function == function) return name;
  return "";
}

class CauseSearch {
 public:
  CauseSearch(const CheckedTask& task, const Values& values,
              const std::vector<std::vector<Cause>>& locals)
      : task_(task), values_(values), locals_(locals) {}

  // Returns whether it has no bounds.
  bool Search(const CheckedExpression& expression) {
    if (IsBounded(Hull(ExpressionBounds(task_, values_).AllOf(expression)))) return false;
    if (SearchRead(expression) || SearchOperands(expression)) return true;
    // All its operands have bounds: it is this operation that loses them.
    return Add(Cause::kOperation, NameOf(expression), expression.span);
  }

  std::vector<Cause> Take() { return std::move(causes_); }

 private:
  bool SearchRead(const CheckedExpression& expression) {
    const Span span = expression.span;
    if (const auto* read = std::get_if<SensorRead>(&expression.node))
      return Add(Cause::kSensor, task_.sensors[read->sensor].name, span);
    if (const auto* read = std::get_if<ParamRead>(&expression.node))
      return Add(Cause::kParam, task_.params[read->param].name, span);
    if (const auto* read = std::get_if<MemoryRead>(&expression.node);
        read != nullptr && IsOfPast(*read))
      return Add(Cause::kOperation, fmt::format("`{}`", NameOfPast(*read)), span);
    if (const auto* read = std::get_if<MemoryRead>(&expression.node))
      return Add(Cause::kMemory, task_.memory[read->memory].name, span);
    if (std::holds_alternative<TimeStep>(expression.node))
      return Add(Cause::kTimeStep, "time_step", span);
    const auto* local = std::get_if<LocalRead>(&expression.node);
    if (local != nullptr) AddCauses(causes_, locals_[local->local]);
    return local != nullptr;
  }

  // `rate#1`
  bool IsOfPast(const MemoryRead& read) const {
    return std::ranges::find(task_.time_functions, read.memory, &CheckedTimeFunction::value) !=
           task_.time_functions.end();
  }
  std::string NameOfPast(const MemoryRead& read) const {
    const std::string& name = task_.memory[read.memory].name;
    return name.substr(0, name.find('#'));
  }

  // Returns whether any of them has no bounds; all are searched.
  bool SearchOperands(const CheckedExpression& expression) {
    bool is_found = false;
    const auto search = [&](const CheckedExpression& operand) {
      is_found = Search(operand) || is_found;
    };
    std::visit(
        [&]<typename Node>(const Node& node) {
          if constexpr (requires { node.operand; }) {
            search(*node.operand);
          } else if constexpr (requires { node.left; }) {
            search(*node.left);
            search(*node.right);
          } else if constexpr (requires { node.arguments; }) {
            for (const CheckedExpressionPtr& argument : node.arguments) search(*argument);
          }
        },
        expression.node);
    return is_found;
  }

  bool Add(Cause::Kind kind, std::string name, Span span) {
    AddCauses(causes_, {{kind, std::move(name), span}});
    return true;
  }

  std::string NameOf(const CheckedExpression& expression) const {
    if (const auto* binary = std::get_if<CheckedBinary>(&expression.node))
      return binary->op == BinaryOperator::kDivide ? "a division by what may be 0" : "an overflow";
    if (const auto* call = std::get_if<BuiltinCall>(&expression.node))
      return fmt::format("`{}`", compiler::NameOf(call->function));
    if (const auto* call = std::get_if<FunctionCall>(&expression.node))
      return fmt::format("`{}`", task_.functions[call->function].name);
    return "`reward`";
  }

  const CheckedTask& task_;
  const Values& values_;
  const std::vector<std::vector<Cause>>& locals_;
  std::vector<Cause> causes_;
};

}  // namespace

std::vector<Cause> CausesOf(const CheckedTask& task, const Values& values,
                            const std::vector<std::vector<Cause>>& locals,
                            const CheckedExpression& expression) {
  CauseSearch search(task, values, locals);
  search.Search(expression);
  return search.Take();
}

void AddCauses(std::vector<Cause>& causes, const std::vector<Cause>& more) {
  for (const Cause& cause : more) {
    const bool is_known = std::ranges::any_of(causes, [&](const Cause& known) {
      return known.kind == cause.kind && known.name == cause.name;
    });
    if (!is_known) causes.push_back(cause);
  }
}

}  // namespace compiler
