#include "compiler/bounds/failures.h"

#include <algorithm>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "compiler/check/traversal.h"

namespace compiler {
namespace {

// The sensors, params, memory and locals that an expression reads: the kind, the index, and the
// element.
using ReadElements = std::set<std::tuple<size_t, uint32_t, uint32_t>>;

const size_t kMemoryKind = decltype(CheckedExpression::node)(MemoryRead{}).index();

std::optional<uint32_t> IndexOfRead(const CheckedExpression& expression) {
  if (const auto* read = std::get_if<SensorRead>(&expression.node)) return read->sensor;
  if (const auto* read = std::get_if<ParamRead>(&expression.node)) return read->param;
  if (const auto* read = std::get_if<MemoryRead>(&expression.node)) return read->memory;
  if (const auto* read = std::get_if<LocalRead>(&expression.node)) return read->local;
  return std::nullopt;
}

void AddElements(size_t kind, uint32_t index, const Type& type, ReadElements& reads) {
  for (uint32_t i = 0; i < type.size(); ++i) reads.insert({kind, index, i});
}

void AddReads(const CheckedExpression& expression, ReadElements& reads) {
  const CheckedExpression* picked_from = nullptr;  // what only some elements are read of
  ForEachPart(expression, [&](const CheckedExpression& part) {
    if (const auto* elements = std::get_if<Elements>(&part.node)) {
      const auto index = IndexOfRead(*elements->operand);
      if (!index) return;
      picked_from = elements->operand.get();
      for (const uint32_t i : elements->indices)
        reads.insert({picked_from->node.index(), *index, i});
    } else if (const auto index = IndexOfRead(part); index && &part != picked_from) {
      AddElements(part.node.index(), *index, part.type, reads);
    }
  });
}

// A statement with the blocks around it, from the event's own, and what their conditions read and
// what they set.
struct StatementPlace {
  uint32_t index;  // of the end or the term
  Span span;
  std::vector<const CheckedBlock*> blocks;
  ReadElements reads;
};

bool AreRelated(const StatementPlace& a, const StatementPlace& b) {
  return std::ranges::any_of(a.reads, [&](const auto& read) { return b.reads.contains(read); });
}

// Does whatever reaches `place` also reach the payment? What is paid in any case is not paid for
// it.
bool IsBeside(const StatementPlace& payment, const StatementPlace& place) {
  const size_t depth = payment.blocks.size();
  return depth > 1 && depth <= place.blocks.size() &&
         std::ranges::equal(payment.blocks,
                            std::span(place.blocks.begin(), place.blocks.begin() + depth));
}

class FailureSearch {
 public:
  explicit FailureSearch(const CheckedTask& task) : task_(task) {
    for (const CheckedEvent& event : task.events) Search(event.body, {}, {});
  }

  std::vector<Failure> Find() const {
    std::vector<Failure> failures;
    for (const StatementPlace& place : failures_) {
      const bool is_known =
          std::ranges::find(failures, place.span, &Failure::span) != failures.end();
      if (!is_known) failures.push_back(FailureAt(place));
    }
    return failures;
  }

 private:
  void Search(const CheckedBlock& block, std::vector<const CheckedBlock*> around,
              const ReadElements& conditions) {
    around.push_back(&block);
    ReadElements reads = conditions;
    // What a block with an end notes down may be what is paid for elsewhere.
    for (const CheckedStatement& statement : block)
      if (const auto* assign = std::get_if<CheckedAssign>(&statement.node);
          assign && !reads.empty())
        AddElements(kMemoryKind, assign->memory, task_.memory[assign->memory].type, reads);
    for (const CheckedStatement& statement : block) {
      const auto* reward = std::get_if<CheckedReward>(&statement.node);
      if (reward != nullptr && !reward->is_rate)
        payments_.push_back({reward->term, statement.span, around, reads});
      const auto* end = std::get_if<CheckedEnd>(&statement.node);
      if (end != nullptr && task_.ends[end->end].kind == EndKind::kFailure)
        failures_.push_back({end->end, statement.span, around, reads});
      if (const auto* loop = std::get_if<CheckedFor>(&statement.node))
        for (const CheckedPass& pass : loop->passes) Search(pass.body, around, reads);
      if (const auto* branches = std::get_if<CheckedIf>(&statement.node))
        Search(*branches, around, reads);
      if (const auto* phases = std::get_if<CheckedPhaseSwitch>(&statement.node))
        for (const CheckedBlock& phase : phases->blocks) Search(phase, around, reads);
    }
  }

  void Search(const CheckedIf& branches, const std::vector<const CheckedBlock*>& around,
              ReadElements conditions) {
    for (const CheckedIfBranch& branch : branches.branches) {
      AddReads(branch.condition, conditions);
      Search(branch.body, around, conditions);
    }
    Search(branches.otherwise, around, conditions);
  }

  Failure FailureAt(const StatementPlace& place) const {
    Failure failure{.end = place.index, .span = place.span};
    std::set<uint32_t> spans;  // where the payments beside it begin
    for (const StatementPlace& payment : payments_) {
      if (!IsBeside(payment, place)) continue;
      failure.beside.insert(payment.index);
      spans.insert(payment.span.begin);
    }
    failure.only_here = failure.beside;
    for (const StatementPlace& payment : payments_) {
      if (!spans.contains(payment.span.begin)) failure.only_here.erase(payment.index);
      if (!failure.beside.contains(payment.index) && AreRelated(payment, place))
        failure.related.insert(payment.index);
    }
    return failure;
  }

  const CheckedTask& task_;
  std::vector<StatementPlace> failures_;
  std::vector<StatementPlace> payments_;
};

}  // namespace

std::vector<Failure> FailuresOf(const CheckedTask& task) { return FailureSearch(task).Find(); }

}  // namespace compiler
