#include "compiler/check/statements.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "compiler/check/assignment.h"
#include "compiler/check/expressions.h"
#include "compiler/check/names.h"
#include "compiler/check/operators.h"
#include "compiler/check/report.h"

namespace compiler {
namespace {

void CollectLets(const Block& block, TaskScope& scope) {
  for (const Statement& statement : block) {
    if (const auto* let = std::get_if<LetStatement>(&statement.node))
      scope.lets.emplace(let->name.text, let->name.span);
    if (const auto* branches = std::get_if<IfStatement>(&statement.node)) {
      for (const IfBranch& branch : branches->branches) CollectLets(branch.body, scope);
      if (branches->otherwise) CollectLets(*branches->otherwise, scope);
    }
  }
}

// The block of one event.
class EventChecker {
 public:
  EventChecker(const EventDeclaration& declaration, TaskScope& scope, CheckedTask& task)
      : place_{Place::kEvent, declaration.event},
        event_name_(declaration.name.text),
        scope_(scope),
        task_(task),
        event_(task.events[static_cast<size_t>(declaration.event)]) {}

  CheckedBlock Check(const Block& block) {
    scope_.symbols.OpenBlock();
    CheckedBlock checked;
    for (const Statement& statement : block)
      std::visit([&](const auto& node) { CheckNode(node, statement.span, checked); },
                 statement.node);
    scope_.symbols.CloseBlock();
    return checked;
  }

 private:
  // Each adds the checked statement to `block`, or reports why not.
  void CheckNode(const LetStatement& let, Span span, CheckedBlock& block) {
    Symbol symbol{.kind = SymbolKind::kLocal, .is_valid = false};
    auto value = CheckExpression(let.value, place_, scope_);
    if (value) {
      symbol = {.kind = SymbolKind::kLocal,
                .index = static_cast<uint32_t>(event_.locals.size()),
                .type = value->type,
                .unit = value->unit};
      event_.locals.push_back({let.name.text, value->type, value->unit});
      block.push_back({span, CheckedLet{symbol.index, std::move(*value)}});
    }
    DeclareSymbol(let.name, symbol, scope_);
  }

  void CheckNode(const AssignStatement& assign, Span span, CheckedBlock& block) {
    if (assign.target.name.text == kReward) return CheckAnonymousReward(assign, span, block);
    auto checked = CheckAssignment(assign, place_, scope_);
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
    auto value = CheckRealNumber(reward.value, "a reward", place_, scope_);
    if (reward.is_rate && !place_.has_time_step()) {
      Report(scope_.diagnostics, code::kMisplacedRate,
             Cover({span.begin, span.begin}, reward.name.span),
             fmt::format("`{}` has no time step to pay for", event_name_),
             {.help = "write `reward` without `rate`, or move this to `on end_of_time_step`"});
      return;
    }
    const uint32_t term = TermOf(reward.name.text, span);
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

  void CheckNode(const ForStatement&, Span, CheckedBlock&) { assert(false); }
  void CheckNode(const OnceStatement&, Span, CheckedBlock&) { assert(false); }
  void CheckNode(const LogStatement&, Span, CheckedBlock&) { assert(false); }
  void CheckNode(const RequireStatement&, Span, CheckedBlock&) { assert(false); }

  void CheckNode(const EndStatement& end, Span span, CheckedBlock& block) {
    if (place_.event == EventKind::kEndOfEpisode) {
      Report(scope_.diagnostics, code::kMisplacedEnd, span,
             "the episode is over already at `end_of_episode`",
             {.help = "end it in another event, such as `end_of_time_step`"});
      return;
    }
    const auto index = static_cast<uint32_t>(task_.ends.size());
    task_.ends.push_back({end.kind, end.reason, span});
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
  const std::string& event_name_;
  TaskScope& scope_;
  CheckedTask& task_;
  CheckedEvent& event_;
};

}  // namespace

void CheckEvents(const SyntaxTree& tree, TaskScope& scope, CheckedTask& task) {
  for (const Declaration& declaration : tree.declarations) {
    const auto* block = std::get_if<EventDeclaration>(&declaration.node);
    if (block == nullptr) continue;
    CheckedEvent& event = task.events[static_cast<size_t>(block->event)];
    if (event.is_declared) {
      Report(scope.diagnostics, code::kRepeatedEvent, block->name.span,
             fmt::format("`{}` has a block already", block->name.text),
             {.help = "put all statements of an event into one block",
              .labels = {{event.span, "the first block"}}});
    }
    scope.lets.clear();
    CollectLets(block->body, scope);
    CheckedBlock body = EventChecker(*block, scope, task).Check(block->body);
    if (event.is_declared) continue;
    event.is_declared = true;
    event.span = block->name.span;
    event.body = std::move(body);
  }
}

}  // namespace compiler
