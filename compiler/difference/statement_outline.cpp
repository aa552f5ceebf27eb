#include "compiler/difference/statement_outline.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "compiler/check/traversal.h"
#include "compiler/syntax/words.h"

namespace compiler {
namespace {

std::set<uint32_t> ChangedIn(const CheckedBlock& block) {
  std::set<uint32_t> changed;
  ForEachStatement(block, [&](const CheckedStatement& statement) {
    if (const auto* assign = std::get_if<CheckedAssign>(&statement.node))
      changed.insert(assign->memory);
  });
  return changed;
}

}  // namespace

std::string EndName(EndKind kind, const std::string& reason) {
  const std::string_view outcome = NameOf(kind, kOutcomeNames);
  return fmt::format("{} \"{}\"", outcome.empty() ? "truncation" : outcome, reason);
}

void StatementOutliner::AddEvent(const std::string& name, const CheckedEvent& event) {
  event_ = name;
  conditions_.clear();
  kept_ = 0;
  writer_.Begin(ChangedIn(event.body));
  AddBlock(event.body);
}

void StatementOutliner::AddBlock(const CheckedBlock& block) {
  for (const CheckedStatement& statement : block)
    std::visit([this](const auto& node) { AddNode(node); }, statement.node);
}

void StatementOutliner::Add(const std::string& kind, const std::string& name,
                            const std::string& what, const std::string& text) {
  std::string whole = event_ + ": ";
  if (!conditions_.empty()) whole += fmt::format("if {}: ", fmt::join(conditions_, ", and "));
  whole += text;
  outline_.Part(kind, name).facts.push_back({what, whole});
  outline_.orders[event_].push_back(fmt::format("{} {}: {}: {}", kind, name, what, whole));
}

void StatementOutliner::AddNode(const CheckedLet& let) {
  ExpressionText value = writer_.Write(let.value);
  if (value.is_changing) {
    const std::string name = fmt::format("value_{}", ++kept_);
    Add("event", event_, "keeps", name + " = " + value.text);
    value = {name, TextBinding::kAtom, true};
  }
  writer_.SetLocal(let.local, std::move(value));
}

void StatementOutliner::AddNode(const CheckedAssign& assign) {
  const CheckedMemory& memory = task_.memory[assign.memory];
  const std::string change =
      fmt::format("{} {} {}", writer_.SelectionText(memory.type, assign.elements),
                  NameOf(assign.op, kAssignSymbols), writer_.Text(assign.value));
  const std::string text = OwnName(memory.name) + change;
  if (memory.is_declared) return Add("memory", memory.name, "is set", text);
  // What the language itself remembers follows from other facts; but when it is set is of the
  // order.
  outline_.orders[event_].push_back(text);
  for (const CheckedStartValue& value : task_.start.values)
    if (value.memory == assign.memory) Add("start", "", "sets", value.name + change);
}

void StatementOutliner::AddNode(const CheckedIf& branches) {
  const size_t outer = conditions_.size();
  for (const CheckedIfBranch& branch : branches.branches) {
    const ExpressionText condition = writer_.Write(branch.condition);
    conditions_.push_back(condition.text);
    AddBlock(branch.body);
    conditions_.back() = condition.binding < TextBinding::kNot ? "not (" + condition.text + ")"
                                                               : "not " + condition.text;
  }
  AddBlock(branches.otherwise);
  conditions_.resize(outer);
}

void StatementOutliner::AddNode(const CheckedFor& loop) {
  for (const CheckedPass& pass : loop.passes) AddBlock(pass.body);
}

void StatementOutliner::AddNode(const CheckedReward& reward) {
  Add("term", task_.terms[reward.term].name, "pays",
      writer_.Text(reward.value) + (reward.is_rate ? " per second" : ""));
}

void StatementOutliner::AddNode(const CheckedEnd& end) {
  const CheckedEndReason& reason = task_.ends[end.end];
  Add("end", EndName(reason.kind, reason.reason), "when", "ends");
}

void StatementOutliner::AddNode(const CheckedLog& log) {
  Add("log", task_.logs[log.log].name, "value", writer_.Text(log.value));
}

void StatementOutliner::AddNode(const CheckedRequire& require) {
  Add("requirement", task_.requirements[require.requirement].reason, "demands",
      writer_.Text(require.condition));
}

void StatementOutliner::AddNode(const CheckedRedraw& redraw) {
  Add("goal", task_.goals[redraw.goal].name, "drawn", "anew");
}

void StatementOutliner::AddNode(const CheckedNext& next) {
  const std::string& phase = conditions_.empty() ? event_ : conditions_.front();
  Add("phases", "", "change", "to " + task_.phases[next.phase].name + " from " + phase);
}

void StatementOutliner::AddNode(const CheckedPhaseSwitch& phases) {
  for (size_t i = 0; i < phases.blocks.size(); ++i) {
    conditions_.push_back("phase == " + task_.phases[i].name);
    AddBlock(phases.blocks[i]);
    conditions_.pop_back();
  }
}

void StatementOutliner::AddNode(const CheckedPotentialStep& step) {
  if (step.moment != CheckedPotentialStep::kAction) return;
  Add("term", task_.terms[task_.potentials[step.potential].term].name, "potential",
      writer_.Text(step.value));
}

}  // namespace compiler
