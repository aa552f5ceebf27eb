#include "compiler/document/equations.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "compiler/check/names.h"
#include "compiler/document/payments.h"
#include "compiler/document/reads.h"

namespace compiler {
namespace {

// "r" and the term's name; the anonymous reward has none.
std::string TermName(const std::string& term) {
  return term == kReward ? "r_{0}" : "r_{" + TextToLatex(term) + "}";
}

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
    equations.locals.push_back({NameToLatex(let->name.text), ToFormula(let->value).text,
                                ReadsOf(let->value), let->name.text});
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
             assign != nullptr && !PaidTerm(statement)) {
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
      const auto term = PaidTerm(statement);
      if (term && std::ranges::find(terms, *term) == terms.end()) terms.push_back(*term);
    });
  }
  std::vector<Formula> names;
  for (const std::string& term : terms) {
    names.push_back({TermName(term)});
    Payment payment = PaymentOf(term, blocks);
    equations.terms.push_back(
        {term, {TermName(term), payment.amount.text, std::move(payment.reads)}});
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
