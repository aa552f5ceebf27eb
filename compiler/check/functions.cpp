#include "compiler/check/functions.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "compiler/check/conversion.h"
#include "compiler/check/declared_type.h"
#include "compiler/check/expressions.h"
#include "compiler/check/fold.h"
#include "compiler/check/names.h"
#include "compiler/check/report.h"
#include "compiler/check/traversal.h"
#include "compiler/check/unit.h"

namespace compiler {
namespace {

constexpr Place kFunctionPlace{Place::kFunction};

template <typename Check>
void ForEachFunction(const SyntaxTree& tree, Check check) {
  for (const Declaration& declaration : tree.declarations)
    if (const auto* function = std::get_if<FunctionDeclaration>(&declaration.node))
      check(*function);
}

bool IsTestName(const Identifier& name, const TaskScope& scope) {
  if (!IsTestFunction(name.text)) return false;
  Report(scope.diagnostics, code::kTakenName, name.span,
         fmt::format("`{}` is what tests read and cannot be declared as a function", name.text),
         {.help = "choose another name"});
  return true;
}

// Of a function that leaves a unit open, some parameter must say by itself what it is.
bool SaysItsUnit(const FunctionDeclaration& function, const FunctionSignature& signature,
                 const TaskScope& scope) {
  const auto has_unit = [](const Local& parameter) { return IsAnyUnit(parameter.unit); };
  if (std::ranges::any_of(signature.parameters, has_unit)) return true;
  std::optional<Span> open;
  if (signature.unit.any != 0) open = function.unit->span;
  for (size_t i = 0; i < signature.parameters.size(); ++i)
    if (signature.parameters[i].unit.any != 0) open = function.parameters[i].unit->span;
  if (!open) return true;
  Report(scope.diagnostics, code::kUnsaidUnit, *open,
         fmt::format("no parameter of `{}` says what `unit` is", function.name.text),
         {.help = "a parameter must have it as it is: `x: real [unit]`"});
  return false;
}

FunctionSignature SignatureOf(const FunctionDeclaration& function, const TaskScope& scope) {
  FunctionSignature signature{.name = function.name};
  for (const FunctionParameter& parameter : function.parameters) {
    const auto type = CheckDeclaredType(parameter.type, parameter.unit, scope);
    signature.is_valid = signature.is_valid && type;
    const DeclaredType declared = type.value_or(DeclaredType{});
    signature.parameters.push_back({parameter.name.text, declared.type, declared.unit});
    signature.parameter_spans.push_back(parameter.name.span);
  }
  const auto result = CheckDeclaredType(function.result, function.unit, scope);
  signature.is_valid = signature.is_valid && result;
  if (result) {
    signature.result = result->type;
    signature.unit = result->unit;
  }
  signature.is_valid = signature.is_valid && SaysItsUnit(function, signature, scope);
  return signature;
}

// ---- Bodies -------------------------------------------------------------------------------------

// What functions know: each other. To it come the parameters and local values of the one that is
// checked.
TaskScope ScopeInside(const TaskScope& task) {
  TaskScope inside{.has_robot = task.has_robot,
                   .knows_robot = task.knows_robot,
                   .knows_names = task.knows_names,
                   .knows_functions = task.knows_functions,
                   .enumerations = task.enumerations,
                   .sensors = {},
                   .symbols = {},
                   .constants = task.constants,
                   .functions = task.functions,
                   .phases = {},
                   .locals = {},
                   .diagnostics = task.diagnostics,
                   .refused = task.refused,
                   .around = &task,
                   .references = task.references};
  for (uint32_t i = 0; i < task.functions.size(); ++i) {
    const Identifier& name = task.functions[i].name;
    inside.symbols.Declare(name.text,
                           {.kind = SymbolKind::kFunction, .span = name.span, .index = i});
  }
  return inside;
}

// Consts and sets, but those whose names the function has for something of its own.
void DeclareConstants(const FunctionDeclaration& function, const TaskScope& around,
                      TaskScope& inside) {
  std::set<std::string_view> own;
  for (const FunctionParameter& parameter : function.parameters) own.insert(parameter.name.text);
  for (const LetStatement& let : function.lets) own.insert(let.name.text);
  for (const Identifier& name : around.constants.names) {
    const Symbol* symbol = around.symbols.Find(name.text);
    if (symbol != nullptr && !own.contains(name.text)) inside.symbols.Declare(name.text, *symbol);
  }
}

void DeclareParameters(const FunctionSignature& signature, TaskScope& inside) {
  for (uint32_t i = 0; i < signature.parameters.size(); ++i) {
    const Local& parameter = signature.parameters[i];
    DeclareSymbol({parameter.name, signature.parameter_spans[i]},
                  {.kind = SymbolKind::kArgument,
                   .is_valid = signature.is_valid,
                   .index = i,
                   .type = parameter.type,
                   .unit = parameter.unit},
                  inside);
  }
}

CheckedFunction CheckBody(const FunctionDeclaration& function, const FunctionSignature& signature,
                          TaskScope& inside) {
  inside.locals.clear();
  for (const LetStatement& let : function.lets)
    inside.locals.emplace(let.name.text, LocalName{let.name.span});
  CheckedFunction checked{
      .name = function.name.text,
      .doc = function.doc,
      .span = function.name.span,
      .arguments = signature.parameters,
      .locals = {},
      .lets = {},
      .value = {function.value.span, signature.result, signature.unit, Constant{}}};
  for (const LetStatement& let : function.lets) {
    Symbol symbol{.kind = SymbolKind::kLocal, .is_valid = false};
    if (auto value = CheckExpression(let.value, kFunctionPlace, inside)) {
      symbol = {.kind = SymbolKind::kLocal,
                .index = static_cast<uint32_t>(checked.locals.size()),
                .type = value->type,
                .unit = value->unit,
                .constant = ValueOf(*value)};
      checked.locals.push_back({let.name.text, value->type, value->unit});
      checked.lets.push_back({symbol.index, std::move(*value)});
    }
    DeclareSymbol(let.name, symbol, inside);
  }
  auto value = CheckExpression(function.value, kFunctionPlace, inside);
  if (value && signature.is_valid)
    value = ConvertTo({std::move(*value), &function.value}, signature.result, signature.unit,
                      fmt::format("the result of `{}`", function.name.text), inside.diagnostics,
                      {{function.result.span, "declared here"}});
  if (value && signature.is_valid) checked.value = std::move(*value);
  return checked;
}

// ---- Calls --------------------------------------------------------------------------------------

// Calls `visit` for each call in a function, with the expression that it is.
template <typename FunctionType, typename Visit>
void ForEachCall(FunctionType& function, const Visit& visit) {
  const auto visit_call = [&](auto& part) {
    if (auto* call = std::get_if<FunctionCall>(&part.node)) visit(*call, part);
  };
  for (auto& let : function.lets) ForEachPart(let.value, visit_call);
  ForEachPart(function.value, visit_call);
}

// How deep functions call each other, and how many calls one call may lead to: what keeps every
// callback short.
constexpr size_t kDeepestCall = 200;
constexpr uint64_t kMostCalls = 10'000;

// Finds functions that call themselves, or too many others: a depth-first search, which looks at
// each function once.
class CallCheck {
 public:
  CallCheck(const CheckedTask& task, Diagnostics& diagnostics)
      : task_(task), diagnostics_(diagnostics), functions_(task.functions.size()) {}

  void Run() {
    for (uint32_t i = 0; i < task_.functions.size() && !is_too_large_; ++i) Visit(i);
  }

 private:
  struct Function {
    enum { kUnseen, kOpen, kDone } state = kUnseen;
    uint64_t calls = 0;  // that a call of it leads to
  };
  struct Step {
    uint32_t caller;
    Span call;
  };

  void Visit(uint32_t index) {
    Function& function = functions_[index];
    if (function.state != Function::kUnseen) return;
    function.state = Function::kOpen;
    ForEachCall(task_.functions[index],
                [&](const FunctionCall& call, const CheckedExpression& part) {
                  way_.push_back({index, part.span});
                  Follow(call.function);
                  const uint64_t times = call.is_each ? part.type.size() : 1;
                  function.calls += times * (1 + functions_[call.function].calls);
                  way_.pop_back();
                });
    function.state = Function::kDone;
    if (!is_too_large_ && function.calls > kMostCalls)
      ReportTooMany(index, fmt::format("a call of `{}` leads to more than {} other calls",
                                       task_.functions[index].name, kMostCalls));
  }

  // Goes on to the function at the end of `way_`.
  void Follow(uint32_t callee) {
    if (is_too_large_) return;
    if (functions_[callee].state == Function::kOpen) {
      if (circles_.insert(callee).second) ReportCircle(callee);
    } else if (way_.size() > kDeepestCall) {
      ReportTooMany(way_.front().caller,
                    fmt::format("from `{}` on, functions call each other more than {} deep",
                                task_.functions[way_.front().caller].name, kDeepestCall));
    } else {
      Visit(callee);
    }
  }

  void ReportTooMany(uint32_t function, std::string message) {
    is_too_large_ = true;
    Report(diagnostics_, code::kTooManyCalls, task_.functions[function].span, std::move(message),
           {.help = "compute what is used several times once, with a `let`"});
  }

  // `way_` ends with a call of `first`, which it came from.
  void ReportCircle(uint32_t first) {
    const auto begin = std::ranges::find(way_, first, &Step::caller);
    const std::string& name = task_.functions[first].name;
    std::vector<std::string> others;
    std::vector<Label> labels;
    for (auto step = begin + 1; step < way_.end(); ++step) {
      const std::string& caller = task_.functions[step->caller].name;
      others.push_back(caller);
      labels.push_back(
          {step->call,
           fmt::format("`{}` is called here",
                       step + 1 == way_.end() ? name : task_.functions[(step + 1)->caller].name)});
    }
    const std::string by_way = others.empty() ? "" : fmt::format(" through {}", List(others));
    Report(diagnostics_, code::kRecursion, begin->call,
           fmt::format("`{}` calls itself{}", name, by_way),
           {.help = "a task always returns, so functions do not call themselves",
            .labels = std::move(labels)});
  }

  const CheckedTask& task_;
  Diagnostics& diagnostics_;
  std::vector<Function> functions_;
  std::vector<Step> way_;
  std::set<uint32_t>
      circles_;  // the functions of which it has been reported that they call themselves
  bool is_too_large_ = false;  // too many calls: that has been reported
};

// Calls `visit` for every call outside of functions.
template <typename Visit>
void ForEachOuterCall(CheckedTask& task, const Visit& visit) {
  const auto visit_parts = [&](CheckedExpression& expression) {
    ForEachPart(expression, [&](CheckedExpression& part) {
      if (auto* call = std::get_if<FunctionCall>(&part.node)) visit(*call);
    });
  };
  const auto visit_block = [&](CheckedEvent& event) {
    ForEachStatement(event.body, [&](CheckedStatement& statement) {
      ForEachExpression(statement, visit_parts);
    });
  };
  visit_block(task.start.block);
  for (CheckedEvent& event : task.events) visit_block(event);
  for (CheckedMetric& metric : task.metrics) visit_parts(metric.value);
  for (CheckedObservation& observation : task.observations) visit_parts(observation.value);
  for (CheckedGoal& goal : task.goals) {
    visit_parts(goal.value);
    if (goal.interval) visit_parts(goal.interval->length);
  }
  for (CheckedTest& test : task.tests)
    for (CheckedTestStatement& statement : test.statements)
      if (auto* expect = std::get_if<CheckedExpect>(&statement.node))
        visit_parts(expect->condition);
}

}  // namespace

void DeclareFunctions(const SyntaxTree& tree, TaskScope& scope) {
  ForEachFunction(tree, [&](const FunctionDeclaration& function) {
    const auto index = static_cast<uint32_t>(scope.functions.size());
    scope.functions.push_back(SignatureOf(function, scope));
    if (IsTestName(function.name, scope)) return;
    DeclareSymbol(function.name, {.kind = SymbolKind::kFunction, .index = index}, scope);
  });
}

void CheckFunctions(const SyntaxTree& tree, const TaskScope& scope, CheckedTask& task) {
  TaskScope inside = ScopeInside(scope);
  ForEachFunction(tree, [&](const FunctionDeclaration& function) {
    const FunctionSignature& signature = scope.functions[task.functions.size()];
    inside.symbols.OpenBlock();
    DeclareConstants(function, scope, inside);
    DeclareParameters(signature, inside);
    task.functions.push_back(CheckBody(function, signature, inside));
    inside.symbols.CloseBlock();
  });
  CallCheck(task, scope.diagnostics).Run();
}

void KeepCalledFunctions(CheckedTask& task) {
  constexpr uint32_t kNotKept = UINT32_MAX;
  std::vector<uint32_t> new_index(task.functions.size(), kNotKept);
  std::vector<CheckedFunction> kept;
  const auto keep = [&](const auto& self, uint32_t function) -> void {
    if (new_index[function] != kNotKept) return;
    CheckedFunction& called = task.functions[function];
    ForEachCall(called, [&](FunctionCall& call, const CheckedExpression&) {
      self(self, call.function);
      call.function = new_index[call.function];
    });
    new_index[function] = static_cast<uint32_t>(kept.size());
    kept.push_back(std::move(called));
  };
  ForEachOuterCall(task, [&](FunctionCall& call) {
    keep(keep, call.function);
    call.function = new_index[call.function];
  });
  task.functions = std::move(kept);
}

}  // namespace compiler
