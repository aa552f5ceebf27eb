#include "compiler/document/equations.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "compiler/syntax/words.h"

namespace compiler {
namespace {

std::string OncePer(MemoryScope scope) {
  return "once per " + std::string(NameOf(scope, kScopeNames));
}

// ---- Rewards: sums of what is paid --------------------------------------------------------------

// "r" and the term's name; the anonymous reward has none.
std::string TermName(const std::string& name) {
  return name.empty() ? "r_{0}" : "r_{" + TextToLatex(name) + "}";
}

struct Payment {
  std::string term;
  Formula amount;
};

std::optional<Payment> PaymentOf(const Statement& statement) {
  if (const auto* reward = std::get_if<RewardStatement>(&statement.node)) {
    Formula amount = ToFormula(reward->value);
    if (reward->is_rate) amount = Product(amount, {"\\Delta t"});
    return Payment{reward->name.text, amount};
  }
  const auto* assign = std::get_if<AssignStatement>(&statement.node);
  if (assign != nullptr && assign->target.name.text == "reward") {
    return Payment{"", ToFormula(assign->value)};
  }
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

// What one term is paid in a block.
class TermCollector {
 public:
  explicit TermCollector(std::string term) : term_(std::move(term)) {}

  // Nothing: this block pays the term nothing.
  std::optional<Formula> Collect(const Block& block) const {
    std::vector<Formula> summands;
    for (const Statement& statement : block) {
      if (auto summand = Collect(statement)) summands.push_back(*summand);
    }
    if (summands.empty()) return std::nullopt;
    return Sum(summands);
  }

 private:
  std::optional<Formula> Collect(const Statement& statement) const {
    if (const auto payment = PaymentOf(statement); payment && payment->term == term_) {
      return payment->amount;
    }
    if (const auto* branch = std::get_if<IfStatement>(&statement.node)) return Collect(*branch);
    if (const auto* loop = std::get_if<ForStatement>(&statement.node)) return Collect(*loop);
    if (const auto* once = std::get_if<OnceStatement>(&statement.node)) return Collect(*once);
    return std::nullopt;
  }

  std::optional<Formula> Collect(const IfStatement& statement) const {
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
    return Cases(rows, otherwise.value_or(Formula{"0"}));
  }

  std::optional<Formula> Collect(const ForStatement& loop) const {
    const auto amount = Collect(loop.body);
    if (!amount) return std::nullopt;
    return Formula{"\\sum_{" + NameToLatex(loop.variable.text) + " \\in " +
                       ToFormula(loop.items).text + "} " + AtLeast(Binding::kProduct, *amount),
                   Binding::kProduct};
  }

  std::optional<Formula> Collect(const OnceStatement& once) const {
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
    return Cases(rows, {"0"});
  }

  std::string term_;
};

// ---- All else: statements and their conditions --------------------------------------------------

// The conditions under which a statement runs, from the outside in.
using Conditions = std::vector<Formula>;
using Visitor = std::function<void(const Statement&, const Conditions&)>;

void Visit(const Block& block, const Conditions& conditions, const Visitor& visitor);

void VisitBody(const Block& body, Conditions conditions, Formula further, const Visitor& visitor) {
  conditions.push_back(std::move(further));
  Visit(body, conditions, visitor);
}

void VisitOnce(const OnceStatement& once, Conditions conditions, const Visitor& visitor) {
  for (const IfBranch& branch : once.branches) {
    const Formula condition = ToFormula(branch.condition);
    VisitBody(branch.body, conditions, {TextToLatex(OncePer(once.scope) + " ") + condition.text},
              visitor);
    conditions.push_back(Not(condition));  // of what comes behind
  }
}

void VisitBranches(const IfStatement& statement, Conditions conditions, const Visitor& visitor) {
  for (const IfBranch& branch : statement.branches) {
    const Formula condition = ToFormula(branch.condition);
    VisitBody(branch.body, conditions, condition, visitor);
    conditions.push_back(Not(condition));  // of what comes behind
  }
  if (statement.otherwise) Visit(*statement.otherwise, conditions, visitor);
}

void Visit(const Block& block, const Conditions& conditions, const Visitor& visitor) {
  for (const Statement& statement : block) {
    visitor(statement, conditions);
    if (const auto* branch = std::get_if<IfStatement>(&statement.node)) {
      VisitBranches(*branch, conditions, visitor);
    } else if (const auto* loop = std::get_if<ForStatement>(&statement.node)) {
      Formula each{TextToLatex("for each ") + NameToLatex(loop->variable.text) + " \\in " +
                   ToFormula(loop->items).text};
      VisitBody(loop->body, conditions, each, visitor);
    } else if (const auto* once = std::get_if<OnceStatement>(&statement.node)) {
      VisitOnce(*once, conditions, visitor);
    }
  }
}

std::string ToText(const Conditions& conditions) {
  return conditions.empty() ? "" : Conjunction(conditions).text;
}

Formula NewValue(const AssignStatement& assign) {
  const Formula target = ToFormula(assign.target);
  const Formula value = ToFormula(assign.value);
  switch (assign.op) {
    case AssignOperator::kSet:
      return value;
    case AssignOperator::kAdd:
      return Sum({target, value});
    case AssignOperator::kSubtract:
      return {target.text + " - " + AtLeast(Binding::kInnerProduct, value), Binding::kSum};
    case AssignOperator::kMultiply:
      return Product(target, value);
    case AssignOperator::kDivide:
      return Quotient(target, value);
  }
  return {};
}

void AddStatement(const Statement& statement, const Conditions& conditions,
                  EventEquations& equations) {
  const std::string condition = ToText(conditions);
  if (const auto* let = std::get_if<LetStatement>(&statement.node)) {
    equations.locals.push_back({NameToLatex(let->name.text), ToFormula(let->value).text});
  } else if (const auto* log = std::get_if<LogStatement>(&statement.node)) {
    equations.logs.push_back(
        {{NameToLatex(log->name.text), ToFormula(log->value).text}, condition});
  } else if (const auto* require = std::get_if<RequireStatement>(&statement.node)) {
    equations.requirements.push_back(
        {{require->reason, ToFormula(require->condition).text}, condition});
  } else if (const auto* end = std::get_if<EndStatement>(&statement.node)) {
    equations.ends.push_back({end->kind, end->reason, condition});
  } else if (const auto* redraw = std::get_if<RedrawStatement>(&statement.node)) {
    equations.redraws.push_back({redraw->goal.text, condition});
  } else if (const auto* next = std::get_if<NextStatement>(&statement.node)) {
    equations.next.push_back({next->phase.text, condition});
  } else if (const auto* assign = std::get_if<AssignStatement>(&statement.node);
             assign != nullptr && !PaymentOf(statement)) {
    equations.memory.push_back(
        {{ToFormula(assign->target).text, NewValue(*assign).text}, condition});
  }
}

// The statements of an event or a phase, in one block or several.
EventEquations EquationsOf(const std::vector<const Block*>& blocks, EventEquations equations) {
  std::vector<std::string> terms;
  for (const Block* block : blocks) {
    Visit(*block, {}, [&](const Statement& statement, const Conditions& conditions) {
      AddStatement(statement, conditions, equations);
      const auto payment = PaymentOf(statement);
      if (payment && std::ranges::find(terms, payment->term) == terms.end()) {
        terms.push_back(payment->term);
      }
    });
  }
  std::vector<Formula> names;
  for (const std::string& term : terms) {
    names.push_back({TermName(term)});
    std::vector<Formula> parts;
    for (const Block* block : blocks) {
      if (auto part = TermCollector(term).Collect(*block)) parts.push_back(std::move(*part));
    }
    equations.terms.push_back({TermName(term), Sum(parts).text});
  }
  equations.total = Sum(names);
  return equations;
}

}  // namespace

EventEquations EquationsOf(const EventDeclaration& event) {
  std::vector<const Block*> blocks = {&event.body};
  for (const Block& appended : event.appended) blocks.push_back(&appended);
  EventEquations equations;
  equations.name = event.name.text;
  equations.doc = event.doc;
  return EquationsOf(blocks, std::move(equations));
}

EventEquations EquationsOf(const PhaseDeclaration& phase) {
  EventEquations equations;
  equations.name = phase.name.text;
  equations.doc = phase.doc;
  return EquationsOf({&phase.body}, std::move(equations));
}

StartEquations EquationsOf(const StartDeclaration& start) {
  EventEquations equations{};
  if (start.block) {
    Visit(*start.block, {}, [&](const Statement& statement, const Conditions& conditions) {
      AddStatement(statement, conditions, equations);
    });
  }
  return {std::move(equations.locals), std::move(equations.memory)};
}

std::vector<Equation> EquationsOf(const FunctionDeclaration& function) {
  std::vector<Formula> parameters;
  for (const FunctionParameter& parameter : function.parameters) {
    parameters.push_back({NameToLatex(parameter.name.text)});
  }
  std::vector<Equation> equations{
      {CallFormula(function.name.text, parameters).text, ToFormula(function.value).text}};
  for (const LetStatement& let : function.lets) {
    equations.push_back({NameToLatex(let.name.text), ToFormula(let.value).text});
  }
  return equations;
}

}  // namespace compiler
