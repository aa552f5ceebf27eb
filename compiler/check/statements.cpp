#include "compiler/check/statements.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "compiler/check/assignment.h"
#include "compiler/check/expressions.h"
#include "compiler/check/fold.h"
#include "compiler/check/goals.h"
#include "compiler/check/hidden_memory.h"
#include "compiler/check/loop.h"
#include "compiler/check/names.h"
#include "compiler/check/operators.h"
#include "compiler/check/phase_names.h"
#include "compiler/check/report.h"
#include "compiler/check/traversal.h"
#include "compiler/check/type.h"

namespace compiler {
namespace {

void CollectLocals(const Block& block, TaskScope& scope) {
  for (const Statement& statement : block) {
    if (const auto* let = std::get_if<LetStatement>(&statement.node))
      scope.locals.emplace(let->name.text, LocalName{let->name.span});
    if (const auto* branches = std::get_if<IfStatement>(&statement.node)) {
      for (const IfBranch& branch : branches->branches) CollectLocals(branch.body, scope);
      if (branches->otherwise) CollectLocals(*branches->otherwise, scope);
    }
    if (const auto* loop = std::get_if<ForStatement>(&statement.node)) {
      scope.locals.emplace(loop->variable.text, LocalName{loop->variable.span, true});
      CollectLocals(loop->body, scope);
    }
    if (const auto* once = std::get_if<OnceStatement>(&statement.node))
      for (const IfBranch& branch : once->branches) CollectLocals(branch.body, scope);
  }
}

bool Contains(Span whole, Span part) { return whole.begin <= part.begin && part.end <= whole.end; }

// Operators, calls and operands, without those of loops inside.
uint32_t PartsIn(const CheckedBlock& block) {
  uint32_t parts = 0;
  for (const CheckedStatement& statement : block) {
    ForEachExpression(statement, [&parts](const CheckedExpression& value) {
      ForEachPart(value, [&parts](const CheckedExpression&) { ++parts; });
    });
    if (const auto* branches = std::get_if<CheckedIf>(&statement.node)) {
      for (const CheckedIfBranch& branch : branches->branches) parts += PartsIn(branch.body);
      parts += PartsIn(branches->otherwise);
    }
  }
  return parts;
}

// The block of one event.
class EventChecker {
 public:
  EventChecker(const EventDeclaration& declaration, LogTable& logs, TaskScope& scope,
               CheckedTask& task)
      : EventChecker(declaration.event, declaration.name.text, logs, scope, task) {
    may_be_phase_ = !declaration.is_known;
  }
  // Of a phase, in each time step.
  EventChecker(const PhaseDeclaration& declaration, LogTable& logs, TaskScope& scope,
               CheckedTask& task)
      : EventChecker(EventKind::kEndOfTimeStep, declaration.name.text, logs, scope, task) {
    may_be_phase_ = true;
  }
  // Of a start; `event` takes its local values.
  EventChecker(const Place& place, LogTable& logs, TaskScope& scope, CheckedTask& task,
               CheckedEvent& event)
      : place_(place),
        event_name_("start"),
        logs_(logs),
        scope_(scope),
        task_(task),
        event_(event) {}

  CheckedBlock Check(const Block& block) {
    scope_.symbols.OpenBlock();
    CheckedBlock checked;
    for (const Statement& statement : block) {
      if (!CountStatement()) break;
      if (!MayStandHere(statement)) continue;
      std::visit([&](const auto& node) { CheckNode(node, statement.span, checked); },
                 statement.node);
    }
    scope_.symbols.CloseBlock();
    return checked;
  }

 private:
  EventChecker(EventKind event, std::string_view name, LogTable& logs, TaskScope& scope,
               CheckedTask& task)
      : place_{Place::kEvent, event},
        event_name_(name),
        logs_(logs),
        scope_(scope),
        task_(task),
        event_(task.events[static_cast<size_t>(event)]) {}

  // A start draws where the robot begins, and nothing else. Reports what does something else.
  bool MayStandHere(const Statement& statement) {
    const auto* assign = std::get_if<AssignStatement>(&statement.node);
    const bool may_stand = place_.kind != Place::kStart ||
                           (assign != nullptr && assign->target.name.text != kReward) ||
                           std::holds_alternative<LetStatement>(statement.node) ||
                           std::holds_alternative<IfStatement>(statement.node) ||
                           std::holds_alternative<ForStatement>(statement.node);
    if (!may_stand)
      Report(scope_.diagnostics, code::kNotInStart, statement.span,
             "a start only sets where the robot begins",
             {.note = "`let`, assignments, `if` and `for` may stand here",
              .help = "move it into an event, such as `on start_of_episode`"});
    return may_stand;
  }

  // Each adds the checked statement to `block`, or reports why not.
  void CheckNode(const LetStatement& let, Span span, CheckedBlock& block) {
    Symbol symbol{.kind = SymbolKind::kLocal, .is_valid = false};
    auto value = CheckExpression(let.value, place_, scope_);
    if (value) {
      symbol = {.kind = SymbolKind::kLocal,
                .index = static_cast<uint32_t>(event_.locals.size()),
                .type = value->type,
                .unit = value->unit,
                .constant = ValueOf(*value)};
      event_.locals.push_back({let.name.text, value->type, value->unit});
      block.push_back({span, CheckedLet{symbol.index, std::move(*value)}});
    }
    DeclareSymbol(let.name, symbol, scope_);
  }

  void CheckNode(const AssignStatement& assign, Span span, CheckedBlock& block) {
    if (assign.target.name.text == kReward) return CheckAnonymousReward(assign, span, block);
    auto checked = CheckAssignment(assign, place_, scope_, task_);
    if (checked) block.push_back({span, std::move(*checked)});
  }

  // `reward += e`: a term that is itself called "reward".
  void CheckAnonymousReward(const AssignStatement& assign, Span span, CheckedBlock& block) {
    auto value = CheckRealNumber(assign.value, "a reward", place_, scope_);
    if (assign.op != AssignOperator::kAdd && assign.op != AssignOperator::kSubtract) {
      Report(scope_.diagnostics, code::kRewardAssignment, assign.target.span,
             "`reward` can only be added to",
             {.help = "write `reward += e`, or give the term a name: `reward NAME = e`"});
      return;
    }
    if (value && assign.op == AssignOperator::kSubtract)
      value = CheckUnaryOperator(UnaryOperator::kNegate, value->span, std::move(*value),
                                 scope_.diagnostics);
    if (!value) return;
    block.push_back(
        {span, CheckedReward{TermOf(std::string(kReward), span), false, std::move(*value)}});
  }

  void CheckNode(const RewardStatement& reward, Span span, CheckedBlock& block) {
    NoteReference(reward.name, ReferenceKind::kTerm, scope_);
    auto value = CheckRealNumber(reward.value, "a reward", place_, scope_);
    const uint32_t term = TermOf(reward.name.text, span);
    if (reward.is_rate && !place_.has_time_step()) {
      const Span head = Cover({span.begin, span.begin}, reward.name.span);
      Report(scope_.diagnostics, code::kMisplacedRate, head,
             fmt::format("`{}` has no time step to pay for", event_name_),
             {.help = {"write `reward` without `rate`, or move this to `on end_of_time_step`",
                       {{head, "reward " + reward.name.text}}}});
      return;
    }
    if (task_.terms[term].doc.empty()) task_.terms[term].doc = reward.doc;
    if (value) block.push_back({span, CheckedReward{term, reward.is_rate, std::move(*value)}});
  }

  void CheckNode(const IfStatement& branches, Span span, CheckedBlock& block) {
    CheckedIf checked;
    for (const IfBranch& branch : branches.branches) {
      auto condition = CheckCondition(branch.condition, place_, scope_);
      CheckedBlock body = Check(branch.body);
      if (condition) checked.branches.push_back({std::move(*condition), std::move(body)});
    }
    if (branches.otherwise) checked.otherwise = Check(*branches.otherwise);
    block.push_back({span, std::move(checked)});
  }

  void CheckNode(const ForStatement& loop, Span span, CheckedBlock& block) {
    const auto values = ResolveLoop(loop, scope_);
    if (!CheckLoopVariable(loop.variable, scope_)) return;
    const bool is_outermost = std::exchange(outermost_, outermost_ ? outermost_ : &loop) == nullptr;
    CheckedFor checked{loop.variable.text, {}};
    if (!values) {
      CheckPass(loop, {"", UnknownLoopVariable()});
    } else {
      for (const LoopValue& value : *values) {
        if (scope_.is_too_long) break;
        checked.passes.push_back({value.text, CheckPass(loop, value)});
      }
    }
    if (is_outermost) outermost_ = nullptr;
    block.push_back({span, std::move(checked)});
  }

  // The body with the variable as a constant. Of its mistakes those are reported that no pass
  // before had in the same place.
  CheckedBlock CheckPass(const ForStatement& loop, const LoopValue& value) {
    if (!CountStatement()) return {};
    Diagnostics found;
    Diagnostics& outer = scope_.diagnostics;
    std::vector<Identifier> reads;
    std::vector<Identifier>* const outer_reads = std::exchange(scope_.loop_reads, &reads);
    scope_.diagnostics = found;
    scope_.symbols.OpenBlock();
    scope_.symbols.Declare(loop.variable.text, value.symbol);
    NoteReference(loop.variable, value.symbol, scope_);
    CheckedBlock body = Check(loop.body);
    scope_.symbols.CloseBlock();
    scope_.diagnostics = outer;
    scope_.loop_reads = outer_reads;
    for (const Diagnostic& diagnostic : found.list())
      if (!outer.Has(diagnostic.code, diagnostic.span))
        outer.Add(WithPass(diagnostic, loop, value, reads));
    if (!CountParts(body)) return {};
    if (outer_reads != nullptr) outer_reads->insert(outer_reads->end(), reads.begin(), reads.end());
    return body;
  }

  // Adds in which pass a mistake was found, where it depends on the variable's value.
  static Diagnostic WithPass(Diagnostic diagnostic, const ForStatement& loop,
                             const LoopValue& value, const std::vector<Identifier>& reads) {
    constexpr std::array kOfValues = {code::kIndexOutOfRange, code::kEmptySet,
                                      code::kDivisionByZero, code::kNotFinite};
    const bool reads_it = std::ranges::any_of(reads, [&](const Identifier& read) {
      return read.text == loop.variable.text && Contains(diagnostic.span, read.span);
    });
    if (reads_it && std::ranges::find(kOfValues, diagnostic.code) != kOfValues.end())
      diagnostic.labels.push_back(
          {loop.variable.span,
           fmt::format("in this iteration: {} = {}", loop.variable.text, value.text)});
    return diagnostic;
  }

  // False where a loop has become too long: that is then reported, once.
  bool CountStatement() {
    if (++scope_.statements <= kMostStatements || outermost_ == nullptr) return true;
    return ReportTooLong(fmt::format("{} statements", kMostStatements));
  }

  // The same, for the body of a loop without the loops inside it, which have counted theirs.
  bool CountParts(const CheckedBlock& body) {
    scope_.loop_parts += PartsIn(body);
    if (scope_.loop_parts <= kMostLoopParts) return true;
    return ReportTooLong(fmt::format("{} operators, calls and operands in loops", kMostLoopParts));
  }

  bool ReportTooLong(std::string_view limit) {
    if (std::exchange(scope_.is_too_long, true)) return false;
    Report(scope_.diagnostics, code::kTooManyPasses,
           Cover(outermost_->variable.span, outermost_->items_span),
           fmt::format("with this loop the task has more than {}", limit),
           {.note = "loops are unrolled: the body once for each value",
            .help = "iterate over fewer values, or use whole arrays: `sum`, `norm`, `any`"});
    return false;
  }

  // `if not once#1 and condition { once#1 = true ... } else if not once#1 and ...`, with one memory
  // of its own.
  void CheckNode(const OnceStatement& once, Span span, CheckedBlock& block) {
    const uint32_t memory = AddFlag(once.scope, span);
    CheckedIf checked;
    for (const IfBranch& branch : once.branches) CheckOnce(branch, span, memory, checked);
    if (checked.branches.size() == once.branches.size())
      block.push_back({span, std::move(checked)});
  }

  void CheckOnce(const IfBranch& branch, Span span, uint32_t memory, CheckedIf& checked) {
    auto condition = CheckCondition(branch.condition, place_, scope_);
    const auto boolean = [&](auto node) {
      return CheckedExpression{
          branch.condition.span, ScalarType(Scalar::kBool), {}, std::move(node)};
    };
    CheckedBlock body;
    body.push_back({span, CheckedAssign{memory, {}, AssignOperator::kSet, boolean(Constant{1})}});
    for (CheckedStatement& statement : Check(branch.body)) body.push_back(std::move(statement));
    if (!condition) return;
    CheckedUnary is_first{UnaryOperator::kNot,
                          std::make_unique<CheckedExpression>(boolean(MemoryRead{memory}))};
    CheckedBinary both{BinaryOperator::kAnd,
                       std::make_unique<CheckedExpression>(boolean(std::move(is_first))),
                       std::make_unique<CheckedExpression>(std::move(*condition))};
    auto whole = Fold(boolean(std::move(both)), scope_.diagnostics);
    checked.branches.push_back({std::move(*whole), std::move(body)});
  }

  uint32_t AddFlag(MemoryScope scope, Span span) {
    const auto is_hidden = [](const CheckedMemory& memory) { return !memory.is_declared; };
    const auto number = std::ranges::count_if(task_.memory, is_hidden) + 1;
    return AddHiddenMemory(fmt::format("once#{}", number), ScalarType(Scalar::kBool), {}, scope,
                           span, task_);
  }

  void CheckNode(const LogStatement& log, Span span, CheckedBlock& block) {
    auto checked = logs_.Check(log, place_);
    if (checked) block.push_back({span, std::move(*checked)});
  }

  void CheckNode(const RequireStatement& require, Span span, CheckedBlock& block) {
    auto condition = CheckCondition(require.condition, place_, scope_);
    if (!condition) return;
    const std::string& reason = require.reason.empty() ? require.text : require.reason;
    const uint32_t index = IndexOf(task_.requirements, span, {.reason = reason, .span = span});
    block.push_back({span, CheckedRequire{index, std::move(*condition)}});
  }

  // The entry of the statement at `span`. In a loop the passes share one.
  template <typename Entry>
  static uint32_t IndexOf(std::vector<Entry>& list, Span span, Entry entry) {
    const auto found = std::ranges::find(list, span, &Entry::span);
    if (found != list.end()) return static_cast<uint32_t>(found - list.begin());
    list.push_back(std::move(entry));
    return static_cast<uint32_t>(list.size() - 1);
  }

  void CheckNode(const RedrawStatement& redraw, Span span, CheckedBlock& block) {
    if (const auto goal = FindGoal(redraw.goal, scope_, task_))
      block.push_back({span, CheckedRedraw{*goal}});
  }

  void CheckNode(const NextStatement& next, Span span, CheckedBlock& block) {
    const auto phase = FindPhase(next.phase, scope_);
    if (!may_be_phase_ && !scope_.phases.empty())
      Report(scope_.diagnostics, code::kMisplacedNext, span,
             "only the block of a phase says what comes next",
             {.help = "move it to `phase NAME { ... }`; what holds in several phases stands in "
                      "each of them"});
    if (phase) block.push_back({span, CheckedNext{*phase}});
  }

  void CheckNode(const EndStatement& end, Span span, CheckedBlock& block) {
    const uint32_t index = IndexOf(task_.ends, span, {end.kind, end.reason, span});
    if (place_.event == EventKind::kEndOfEpisode) {
      Report(scope_.diagnostics, code::kMisplacedEnd, span,
             "the episode is already over at `end_of_episode`",
             {.help = "end it in another event, such as `end_of_time_step`"});
      return;
    }
    block.push_back({span, CheckedEnd{index}});
  }

  // The reward term of this name. Several statements may pay the same term.
  uint32_t TermOf(const std::string& name, Span span) {
    const auto found = std::ranges::find(task_.terms, name, &CheckedTerm::name);
    if (found != task_.terms.end()) return static_cast<uint32_t>(found - task_.terms.begin());
    task_.terms.push_back({name, "", span});
    return static_cast<uint32_t>(task_.terms.size() - 1);
  }

  const Place place_;
  const std::string_view event_name_;
  LogTable& logs_;
  TaskScope& scope_;
  CheckedTask& task_;
  CheckedEvent& event_;
  bool may_be_phase_ = false;
  const ForStatement* outermost_ = nullptr;  // of the loops that are being checked
};

}  // namespace

void CheckEvents(const SyntaxTree& tree, LogTable& logs, TaskScope& scope, CheckedTask& task) {
  for (const Declaration& declaration : tree.declarations) {
    const auto* block = std::get_if<EventDeclaration>(&declaration.node);
    if (block == nullptr) continue;
    CheckedEvent& event = task.events[static_cast<size_t>(block->event)];
    if (event.is_declared && block->is_known) {
      Report(scope.diagnostics, code::kRepeatedEvent, block->name.span,
             fmt::format("`{}` has a block already", block->name.text),
             {.help = "put all statements of an event into one block",
              .labels = {{event.span, "the first block"}}});
    }
    scope.locals.clear();
    CollectLocals(block->body, scope);
    for (const Block& appended : block->appended) CollectLocals(appended, scope);
    EventChecker checker(*block, logs, scope, task);
    CheckedBlock body = checker.Check(block->body);
    for (const Block& appended : block->appended)
      std::ranges::move(checker.Check(appended), std::back_inserter(body));
    if (event.is_declared || !block->is_known) continue;
    event.is_declared = true;
    event.span = block->name.span;
    event.body = std::move(body);
  }
}

CheckedBlock CheckPhaseBlock(const PhaseDeclaration& phase, LogTable& logs, TaskScope& scope,
                             CheckedTask& task) {
  scope.locals.clear();
  CollectLocals(phase.body, scope);
  return EventChecker(phase, logs, scope, task).Check(phase.body);
}

void CheckStartBlock(const Block& block, const StartTable& table, LogTable& logs, TaskScope& scope,
                     CheckedTask& task) {
  scope.locals.clear();
  CollectLocals(block, scope);
  uint32_t draws = 1;  // the first is that of the pose
  const Place place{.kind = Place::kStart, .draws = &draws, .start = &table};
  CheckedEvent checked;
  checked.body = EventChecker(place, logs, scope, task, checked).Check(block);
  checked.is_declared = true;
  checked.span = task.start.span;
  task.start.block = std::move(checked);
}

}  // namespace compiler
