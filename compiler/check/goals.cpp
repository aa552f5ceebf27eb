#include "compiler/check/goals.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "compiler/check/conversion.h"
#include "compiler/check/declared_type.h"
#include "compiler/check/draws.h"
#include "compiler/check/expressions.h"
#include "compiler/check/fold.h"
#include "compiler/check/hidden_memory.h"
#include "compiler/check/names.h"
#include "compiler/check/report.h"
#include "compiler/check/stream.h"
#include "compiler/check/type.h"

namespace compiler {
namespace {

constexpr Unit kSeconds{.second = 1};

// One goal.
class GoalCheck {
 public:
  GoalCheck(const GoalDeclaration& goal, TaskScope& scope, CheckedTask& task)
      : goal_(goal), scope_(scope), task_(task) {}

  void Check() {
    Symbol symbol{.kind = SymbolKind::kGoal, .is_valid = false};
    const auto declared = CheckDeclaredType(goal_.type, goal_.unit, scope_);
    if (declared) {
      auto value = CheckValue(*declared);
      std::optional<CheckedExpression> interval;
      if (goal_.draw.shortest) interval = CheckInterval();
      if (value && interval.has_value() == goal_.draw.shortest.has_value()) {
        symbol = {.kind = SymbolKind::kGoal,
                  .index = static_cast<uint32_t>(task_.memory.size()),
                  .type = declared->type,
                  .unit = declared->unit};
        Add(*declared, std::move(*value), std::move(interval));
      }
    }
    DeclareSymbol(goal_.name, symbol, scope_);
  }

 private:
  // Its value, or that of each element.
  std::optional<CheckedExpression> CheckValue(const DeclaredType& declared) {
    auto value = CheckExpression(goal_.draw.value, place_, scope_);
    if (!value) return std::nullopt;
    if (declared.type.scalar != Scalar::kReal && std::holds_alternative<Draw>(value->node) &&
        value->type.scalar == Scalar::kReal) {
      const bool is_bool = IsBool(declared.type);
      Report(scope_.diagnostics, code::kBadDraw, value->span,
             fmt::format("this draws a `real`, and `{}` is {}", goal_.name.text,
                         WithArticle(declared.type)),
             {.help = fmt::format("name the values: `choose({})`",
                                  is_bool ? "true, false" : "0, 1, 2")});
      return std::nullopt;
    }
    const Type type = IsScalar(value->type) ? ScalarType(declared.type.scalar) : declared.type;
    value = ConvertTo({std::move(*value), &goal_.draw.value}, type, declared.unit,
                      fmt::format("`{}`", goal_.name.text), scope_.diagnostics);
    if (value) DrawEachElement(*value, declared.type);
    return value;
  }

  // The length of time from one draw to the next.
  std::optional<CheckedExpression> CheckInterval() {
    const auto* word = std::get_if<NameExpression>(&goal_.draw.shortest->node);
    if (word != nullptr && (word->name.text == "action" || word->name.text == "run")) {
      BadInterval(goal_.draw.shortest->span,
                  fmt::format("no goal is drawn per {}", word->name.text));
      return std::nullopt;
    }
    auto shortest = CheckLength(*goal_.draw.shortest);
    if (!goal_.draw.longest) return shortest;
    auto longest = CheckLength(*goal_.draw.longest);
    if (!shortest || !longest) return std::nullopt;
    const Span span = Cover(shortest->span, longest->span);
    const auto low = ValueOf(*shortest);
    const auto high = ValueOf(*longest);
    if (low && high && *low > *high) {
      Report(scope_.diagnostics, code::kBadInterval, span, "the range is empty",
             {.help = "write the smaller end first"});
      return std::nullopt;
    }
    Draw draw{Distribution::kUniform, draws_++, {}};
    draw.arguments.push_back(std::make_unique<CheckedExpression>(std::move(*shortest)));
    draw.arguments.push_back(std::make_unique<CheckedExpression>(std::move(*longest)));
    return CheckedExpression{span, kRealType, kSeconds, std::move(draw)};
  }

  std::optional<CheckedExpression> CheckLength(const Expression& written) {
    auto length = CheckExpression(written, place_, scope_);
    if (!length) return std::nullopt;
    length = ConvertTo({std::move(*length), &written}, kRealType, kSeconds,
                       fmt::format("the time for which `{}` stays", goal_.name.text),
                       scope_.diagnostics);
    if (!length || ValueOf(*length).value_or(1) > 0) return length;
    BadInterval(written.span, "a goal stays for a while");
    return std::nullopt;
  }

  void BadInterval(Span span, std::string message) {
    Report(scope_.diagnostics, code::kBadInterval, span, std::move(message),
           {.help = "write `per episode`, or a time as in `per 3 s` and `per 3 s .. 8 s`"});
  }

  void Add(const DeclaredType& declared, CheckedExpression value,
           std::optional<CheckedExpression> interval) {
    const std::string& name = goal_.name.text;
    const Span span = goal_.name.span;
    CheckedGoal goal{.name = name,
                     .doc = goal_.doc,
                     .type = declared.type,
                     .unit = declared.unit,
                     .stream = StreamOf(name),
                     .value = std::move(value),
                     .interval = {},
                     .span = span};
    // No reset takes away what a host has set.
    goal.memory =
        AddHiddenMemory(name, declared.type, declared.unit, MemoryScope::kPerRun, span, task_);
    goal.held = AddHiddenMemory(name + "#held", ScalarType(Scalar::kBool), {}, MemoryScope::kPerRun,
                                span, task_);
    goal.draws = AddHiddenMemory(name + "#draws", ScalarType(Scalar::kInt), {},
                                 MemoryScope::kPerEpisode, span, task_);
    if (interval) {
      const uint32_t left = AddHiddenMemory(name + "#left", kRealType, kSeconds,
                                            MemoryScope::kPerEpisode, span, task_);
      goal.interval = {left, std::move(*interval)};
    }
    task_.goals.push_back(std::move(goal));
  }

  const GoalDeclaration& goal_;
  TaskScope& scope_;
  CheckedTask& task_;
  uint32_t draws_ = 0;
  const Place place_{.kind = Place::kGoal, .draws = &draws_};
};

CheckedExpressionPtr Seconds(Span span, decltype(CheckedExpression::node) node) {
  return std::make_unique<CheckedExpression>(
      CheckedExpression{span, kRealType, kSeconds, std::move(node)});
}

// `left -= time_step`, and a new draw where less is left than half a step: at the step that ends
// nearest to the time.
void AddTimer(uint32_t index, const CheckedGoal& goal, CheckedBlock& body) {
  const Span span = goal.span;
  const uint32_t left = goal.interval->left;
  body.push_back(
      {span, CheckedAssign{
                 left, {}, AssignOperator::kSubtract, {span, kRealType, kSeconds, TimeStep{}}}});
  CheckedBinary half{
      BinaryOperator::kMultiply,
      std::make_unique<CheckedExpression>(CheckedExpression{span, kRealType, {}, Constant{0.5}}),
      Seconds(span, TimeStep{})};
  CheckedBinary is_over{BinaryOperator::kLess, Seconds(span, MemoryRead{left}),
                        Seconds(span, std::move(half))};
  CheckedIf check;
  CheckedBlock redraw;
  redraw.push_back({span, CheckedRedraw{index}});
  check.branches.push_back(
      {{span, ScalarType(Scalar::kBool), {}, std::move(is_over)}, std::move(redraw)});
  body.push_back({span, std::move(check)});
}

}  // namespace

void CheckGoals(const SyntaxTree& tree, TaskScope& scope, CheckedTask& task) {
  for (const Declaration& declaration : tree.declarations)
    if (const auto* goal = std::get_if<GoalDeclaration>(&declaration.node))
      GoalCheck(*goal, scope, task).Check();
}

std::optional<uint32_t> FindGoal(const Identifier& name, const TaskScope& scope,
                                 const CheckedTask& task) {
  const Symbol* symbol = FindSymbol(name, scope);
  if (symbol != nullptr && symbol->kind == SymbolKind::kGoal) {
    if (!symbol->is_valid) return std::nullopt;
    const auto goal = std::ranges::find(task.goals, symbol->index, &CheckedGoal::memory);
    return static_cast<uint32_t>(goal - task.goals.begin());
  }
  const bool is_lost = !scope.knows_names || scope.refused.contains(name.text);
  if (symbol == nullptr && is_lost) return std::nullopt;
  std::vector<std::string> goals;
  std::ranges::transform(task.goals, std::back_inserter(goals), &CheckedGoal::name);
  Help help = goals.empty() ? Help("goals are declared with `goal NAME: TYPE = ...`")
                            : Suggest(name.span, name.text, goals, "goals");
  Report(scope.diagnostics, code::kUnknownGoal, name.span,
         symbol == nullptr ? fmt::format("there is no goal `{}`", name.text)
                           : fmt::format("`{}` is {}, not a goal", name.text, WhatIs(symbol->kind)),
         {.help = std::move(help)});
  return std::nullopt;
}

void AddGoalStatements(CheckedTask& task) {
  CheckedBlock first;
  for (uint32_t i = 0; i < task.goals.size(); ++i) {
    first.push_back({task.goals[i].span, CheckedRedraw{i}});
    if (task.goals[i].interval)
      AddTimer(i, task.goals[i], task.events[static_cast<size_t>(EventKind::kEndOfTimeStep)].body);
  }
  CheckedBlock& start = task.events[static_cast<size_t>(EventKind::kStartOfEpisode)].body;
  std::ranges::move(start, std::back_inserter(first));
  start = std::move(first);
}

}  // namespace compiler
