#include "compiler/document/payments.h"

#include <utility>

#include "compiler/check/names.h"
#include "compiler/document/reads.h"
#include "compiler/syntax/words.h"

namespace compiler {
namespace {

// What a statement pays in itself.
struct Amount {
  const Expression& value;
  bool is_rate;
};

std::optional<Amount> AmountOf(const Statement& statement) {
  if (const auto* reward = std::get_if<RewardStatement>(&statement.node))
    return Amount{reward->value, reward->is_rate};
  const auto* assign = std::get_if<AssignStatement>(&statement.node);
  if (assign != nullptr && assign->target.name.text == kReward) return Amount{assign->value, false};
  return std::nullopt;
}

struct Row {
  Formula condition;
  Formula amount;
};

Formula Cases(const std::vector<Row>& rows, const Formula& otherwise) {
  std::string text = "\\begin{cases} ";
  for (const Row& row : rows) {
    text += row.amount.text + " & \\text{if } " + row.condition.text + " \\\\ ";
  }
  return {text + otherwise.text + " & \\text{otherwise} \\end{cases}"};
}

class Collector {
 public:
  explicit Collector(std::string term) : term_(std::move(term)) {}

  // Nothing: this block pays the term nothing.
  std::optional<Formula> Collect(const Block& block) {
    std::vector<Formula> summands;
    for (const Statement& statement : block) {
      if (auto summand = Collect(statement)) summands.push_back(*summand);
    }
    if (summands.empty()) return std::nullopt;
    return Sum(summands);
  }

  // Of all that was collected.
  std::vector<std::string> TakeReads() { return std::move(reads_); }

 private:
  std::optional<Formula> Collect(const Statement& statement) {
    if (PaidTerm(statement) == term_) {
      const auto amount = AmountOf(statement);
      AddReads(amount->value, reads_);
      const Formula formula = ToFormula(amount->value);
      return amount->is_rate ? Product(formula, {"\\Delta t"}) : formula;
    }
    if (const auto* branch = std::get_if<IfStatement>(&statement.node)) return Collect(*branch);
    if (const auto* loop = std::get_if<ForStatement>(&statement.node)) return Collect(*loop);
    if (const auto* once = std::get_if<OnceStatement>(&statement.node)) return Collect(*once);
    return std::nullopt;
  }

  std::optional<Formula> Collect(const IfStatement& statement) {
    std::vector<Row> rows;
    bool is_paid = false;
    for (const IfBranch& branch : statement.branches) {
      const auto amount = Collect(branch.body);
      is_paid |= amount.has_value();
      rows.push_back({ToFormula(branch.condition), amount.value_or(Formula{"0"})});
    }
    const auto otherwise =
        statement.otherwise ? Collect(*statement.otherwise) : std::optional<Formula>();
    if (!is_paid && !otherwise) return std::nullopt;
    if (!otherwise) {
      while (rows.back().amount.text == "0") rows.pop_back();
    }
    AddConditions(statement.branches, rows.size());
    return Cases(rows, otherwise.value_or(Formula{"0"}));
  }

  std::optional<Formula> Collect(const ForStatement& loop) {
    const auto amount = Collect(loop.body);
    if (!amount) return std::nullopt;
    return Formula{"\\sum_{" + NameToLatex(loop.variable.text) + " \\in " +
                       ToFormula(loop.items).text + "} " + AtLeast(Binding::kProduct, *amount),
                   Binding::kProduct};
  }

  std::optional<Formula> Collect(const OnceStatement& once) {
    std::vector<Row> rows;
    bool is_paid = false;
    for (const IfBranch& branch : once.branches) {
      const auto amount = Collect(branch.body);
      is_paid |= amount.has_value();
      Formula condition{TextToLatex(OncePer(once.scope) + ", ") + ToFormula(branch.condition).text};
      rows.push_back({condition, amount.value_or(Formula{"0"})});
    }
    if (!is_paid) return std::nullopt;
    while (rows.back().amount.text == "0") rows.pop_back();
    AddConditions(once.branches, rows.size());
    return Cases(rows, {"0"});
  }

  // Of the first `count` branches: those that stand in the formula.
  void AddConditions(const std::vector<IfBranch>& branches, size_t count) {
    for (size_t i = 0; i < count; ++i) AddReads(branches[i].condition, reads_);
  }

  std::string term_;
  std::vector<std::string> reads_;
};

}  // namespace

std::string OncePer(MemoryScope scope) {
  return "once per " + std::string(NameOf(scope, kScopeNames));
}

std::optional<std::string> PaidTerm(const Statement& statement) {
  if (const auto* reward = std::get_if<RewardStatement>(&statement.node)) return reward->name.text;
  if (AmountOf(statement)) return std::string(kReward);
  return std::nullopt;
}

Payment PaymentOf(const std::string& term, const std::vector<const Block*>& blocks) {
  Collector collector(term);
  std::vector<Formula> parts;
  for (const Block* block : blocks) {
    if (auto part = collector.Collect(*block)) parts.push_back(std::move(*part));
  }
  return {Sum(parts), collector.TakeReads()};
}

}  // namespace compiler
