#include "compiler/check/test_blocks.h"

#include <algorithm>
#include <map>
#include <utility>

#include "compiler/check/constant_value.h"
#include "compiler/check/expressions.h"
#include "compiler/check/given_orientation.h"
#include "compiler/check/names.h"
#include "compiler/check/phase_names.h"
#include "compiler/check/report.h"
#include "compiler/check/target.h"
#include "compiler/check/type.h"
#include "compiler/syntax/words.h"

namespace compiler {
namespace {

constexpr Place kGivenPlace{Place::kGiven};

// The statements of one test.
class TestChecker {
 public:
  TestChecker(const TaskScope& scope, const CheckedTask& task)
      : scope_(scope), task_(task), orientation_(scope.sensors) {}

  std::vector<CheckedTestStatement> Check(const TestDeclaration& test) {
    for (const TestStatement& statement : test.statements)
      std::visit([&](const auto& node) { CheckNode(node, statement.span); }, statement.node);
    return std::move(checked_);
  }

 private:
  // What is given, as the expression that reads it, with the number of names that it has.
  using Whole = std::optional<ResolvedPath>;

  void CheckNode(const GivenStatement& given, Span span) {
    if (IsPhase(given.target)) return CheckGivenPhase(given, span);
    auto whole = ResolveGiven(given.target);
    std::optional<CheckedExpression> target;
    CheckedGiven checked;
    if (whole) {
      Identify(whole->expression, checked);
      target = SelectTarget(std::move(whole->expression), given.target, whole->length, scope_);
    }
    auto value = CheckExpression(given.value, kGivenPlace, scope_);
    if (!target || !value) return;
    checked.elements = ElementsOf(*target);
    value = FitTo({std::move(*value), &given.value}, *target, given.target, scope_);
    if (!value || !CanOccur(checked, *value)) return;
    std::vector<CheckedGiven> implied;
    if (checked.target == CheckedGiven::kSensor)
      implied = orientation_.Give(checked.index, checked.elements,
                                  *ConstantValueOf(*value, scope_.constants.consts));
    checked.value = std::move(*value);
    Add(span, std::move(checked));
    for (CheckedGiven& further : implied) Add(span, std::move(further));
  }

  bool IsPhase(const Target& target) const {
    const Symbol* symbol = scope_.symbols.Find(PathOf(target).front().text);
    return symbol != nullptr && symbol->kind == SymbolKind::kPhase;
  }

  // `given phase = lift`: it begins now.
  void CheckGivenPhase(const GivenStatement& given, Span span) {
    const auto* name = std::get_if<NameExpression>(&given.value.node);
    if (name == nullptr || given.target.name.span.end < given.target.span.end)
      return Report(scope_.diagnostics, code::kPhaseAsValue,
                    name == nullptr ? given.value.span : given.target.span,
                    "a phase is given by its name",
                    {.help = fmt::format("write `given phase = {}`", scope_.phases.back())});
    const auto phase = FindPhase(name->name, scope_);
    if (!phase) return;
    const auto give = [&](uint32_t memory, double value) {
      const CheckedMemory& variable = task_.memory[memory];
      CheckedGiven checked{
          .target = CheckedGiven::kMemory,
          .index = memory,
          .elements = {},
          .value = {given.value.span, variable.type, variable.unit, Constant{value}}};
      Add(span, std::move(checked));
    };
    give(task_.phase_memory.present, *phase);
    give(task_.phase_memory.time, 0);
  }

  Whole ResolveGiven(const Target& target) {
    const std::vector<Identifier> path = PathOf(target);
    const Identifier& root = path.front();
    if (root.text == kTimeStep)
      return ResolvedPath{{root.span, kRealType, Unit{.second = 1}, TimeStep{}}, 1};
    if (root.text == kDiscount && path.size() == 1 && !IsDeclared(root.text))
      return ResolvedPath{{root.span, kRealType, {}, Constant{}}, 1};
    const bool is_value_of_language =
        root.text == kReward || root.text == kPi || root.text == kEnded;
    const Symbol* declared = scope_.symbols.Find(root.text);
    if (declared != nullptr ? IsNamedConstant(*declared) : is_value_of_language)
      return CannotBeGiven(root);
    auto whole = ResolvePath(path, {.kind = Place::kExpect, .tested = &task_}, scope_);
    const bool is_constant = whole && std::holds_alternative<BuiltinCall>(whole->expression.node);
    if (is_constant) return CannotBeGiven({target.name.text, whole->expression.span});
    return whole;
  }

  // Params and the like may be called `discount`.
  bool IsDeclared(const std::string& name) const {
    return scope_.symbols.Find(name) != nullptr || scope_.sensors.IsRoot(name);
  }

  Whole CannotBeGiven(const Identifier& name) {
    Report(scope_.diagnostics, code::kNotGivable, name.span,
           fmt::format("`{}` cannot be given", name.text),
           {.help = "a test gives sensors, params, memory, goals, `phase`, `time_step` and "
                    "`discount`"});
    return std::nullopt;
  }

  void Identify(const CheckedExpression& whole, CheckedGiven& given) const {
    if (const auto* sensor = std::get_if<SensorRead>(&whole.node)) {
      given.target = CheckedGiven::kSensor;
      given.index = sensor->sensor;
    } else if (const auto* param = std::get_if<ParamRead>(&whole.node)) {
      given.target = CheckedGiven::kParam;
      given.index = param->param;
    } else if (const auto* memory = std::get_if<MemoryRead>(&whole.node)) {
      const auto goal = std::ranges::find(task_.goals, memory->memory, &CheckedGoal::memory);
      const bool is_goal = goal != task_.goals.end();
      given.target = is_goal ? CheckedGiven::kGoal : CheckedGiven::kMemory;
      given.index = is_goal ? static_cast<uint32_t>(goal - task_.goals.begin()) : memory->memory;
    } else {
      const bool is_time_step = std::holds_alternative<TimeStep>(whole.node);
      given.target = is_time_step ? CheckedGiven::kTimeStep : CheckedGiven::kDiscount;
    }
  }

  bool CanOccur(const CheckedGiven& given, const CheckedExpression& value) {
    const double number = RealOf(*ConstantValueOf(value, scope_.constants.consts));
    if (given.target == CheckedGiven::kTimeStep && number < 0) {
      Report(scope_.diagnostics, code::kBadGiven, value.span, "a time step is never negative");
      return false;
    }
    if (given.target == CheckedGiven::kDiscount && (number < 0 || number > 1)) {
      Report(scope_.diagnostics, code::kBadGiven, value.span, "a discount is from 0 to 1");
      return false;
    }
    if (given.target != CheckedGiven::kParam) return true;
    const CheckedParam& param = task_.params[given.index];
    if (number >= param.minimum && number <= param.maximum) return true;
    Report(scope_.diagnostics, code::kBadGiven, value.span,
           fmt::format("this is outside the range of `{}`", param.name),
           {.labels = {{param.span, "declared here"}}});
    return false;
  }

  void CheckNode(const FireStatement& fire, Span span) {
    for (const FiredEvent& fired : fire.events) Add(span, CheckedFire{fired.event, fired.times});
  }

  void CheckNode(const ExpectStatement& expect, Span span) {
    auto condition =
        CheckCondition(expect.condition, {.kind = Place::kExpect, .tested = &task_}, scope_);
    if (condition) Add(span, CheckedExpect{std::move(*condition)});
  }

  void CheckNode(const ExpectEndStatement& expect, Span span) {
    const EndStatement& end = expect.end;
    const bool is_known = std::ranges::any_of(task_.ends, [&](const CheckedEndReason& known) {
      return known.kind == end.kind && known.reason == end.reason;
    });
    if (!is_known) return ReportUnknownEnd(end, span);
    Add(span, CheckedExpectEnd{end.kind, end.reason});
  }

  void ReportUnknownEnd(const EndStatement& end, Span span) {
    if (!scope_.knows_names || scope_.refused.contains(end.reason)) return;
    std::vector<std::string> known;
    for (const CheckedEndReason& reason : task_.ends)
      known.push_back(EndText(reason.kind, reason.reason));
    const std::string text = EndText(end.kind, end.reason);
    // The same reason is nearer than any spelling.
    const auto same = std::ranges::find(task_.ends, end.reason, &CheckedEndReason::reason);
    Report(scope_.diagnostics, code::kUnknownEnd, span,
           fmt::format("no event of this task has `{}`", text),
           {.help = same != task_.ends.end()
                        ? WriteInstead(span, "expect " + EndText(same->kind, same->reason))
                        : Suggest(end.span, text, known, "ends of this task")});
  }

  template <typename Node>
  void Add(Span span, Node node) {
    CheckedTestStatement& statement = checked_.emplace_back();
    statement.span = span;
    statement.node = std::move(node);
  }

  const TaskScope& scope_;
  const CheckedTask& task_;
  GivenOrientation orientation_;
  std::vector<CheckedTestStatement> checked_;
};

}  // namespace

std::string EndText(EndKind kind, const std::string& reason) {
  if (kind == EndKind::kTruncated) return fmt::format("truncate_episode \"{}\"", reason);
  return fmt::format("end_episode {} \"{}\"", NameOf(kind, kOutcomeNames), reason);
}

void CheckTests(const SyntaxTree& tree, const TaskScope& scope, CheckedTask& task) {
  std::map<std::string, Span> seen;
  for (const Declaration& declaration : tree.declarations) {
    const auto* test = std::get_if<TestDeclaration>(&declaration.node);
    if (test == nullptr) continue;
    const auto [first, is_new] = seen.try_emplace(test->name, test->name_span);
    if (!is_new)
      Report(scope.diagnostics, code::kRepeatedName, test->name_span,
             fmt::format("there is already a test \"{}\"", test->name),
             {.labels = {{first->second, "first declared here"}}});
    CheckedTest checked{test->name, test->name_span, {}};
    checked.statements = TestChecker(scope, task).Check(*test);
    task.tests.push_back(std::move(checked));
  }
}

}  // namespace compiler
