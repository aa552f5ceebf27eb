// Sections of a task's page: what happens in an episode, and what it pays.
#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "compiler/bounds/bounds.h"
#include "compiler/document/automaton.h"
#include "compiler/document/reads.h"
#include "compiler/document/task_sections.h"
#include "compiler/document/value_text.h"
#include "compiler/syntax/words.h"

namespace compiler {
namespace {

std::string_view WordOf(EndKind kind) {
  const std::string_view outcome = NameOf(kind, kOutcomeNames);
  return outcome.empty() ? "truncated" : outcome;
}

// A formula as a cell; empty where there is none.
Text MathOrNothing(const std::string& latex) { return latex.empty() ? Text{} : Math(latex); }

Formulas RewardFormulas(const EventEquations& event) {
  Formulas formulas;
  for (const auto& [term, equation] : event.terms)
    formulas.lines.push_back({equation.left, "=", equation.right, term, equation.reads});
  if (formulas.lines.size() == 1) {
    formulas.lines.front().left = "r";
  } else {
    formulas.lines.insert(formulas.lines.begin(), {"r", "=", event.total.text});
  }
  return formulas;
}

// Says what the signs of the formulas above mean.
void AddSigns(const EventEquations& event, PageBuilder& page) {
  const auto contains = [&](std::string_view sign) {
    return std::ranges::any_of(event.terms, [&](const TermEquation& term) {
      return term.equation.right.find(sign) != std::string::npos;
    });
  };
  if (!contains("\\Delta t")) return;
  Text text = Math("\\Delta t");
  text.push_back({Piece::kPlain, " is the length of the time step."});
  page.AddParagraph(std::move(text));
}

Text IntervalText(const std::optional<Interval>& interval) {
  if (!interval) return {};
  return Plain(ToText(interval->low) + " .. " + ToText(interval->high));
}

// A potential pays each action.
std::optional<Interval> EachTime(const TermBounds& term) {
  return term.potential ? PaymentOfPotential(*term.potential) : term.payment;
}

Text WeightText(const TaskParts& parts, std::optional<uint32_t> param) {
  return param ? Code(parts.task.params[*param].name) : Text{};
}

std::string ReductionOf(const TaskParts& parts, const std::string& latex) {
  for (const CheckedLogValue& log : parts.task.logs) {
    if (NameToLatex(log.name) == latex) return std::string(NameOf(log.reduction, kReductionNames));
  }
  return "";
}

}  // namespace

// What is drawn where an episode begins.
void AddStart(const TaskParts& parts, PageBuilder& page) {
  for (const StartDeclaration* start : All<StartDeclaration>(parts.tree)) {
    const StartEquations equations = EquationsOf(*start);
    if (equations.values.empty()) continue;
    page.AddHeading("Start of an episode");
    Table table{{"becomes", "when"}, {}};
    for (const ConditionalEquation& value : equations.values) {
      table.rows.push_back({Math(value.equation.left + " \\leftarrow " + value.equation.right),
                            WhenText(value.condition)});
    }
    page.AddTable(std::move(table));
    if (equations.locals.empty()) continue;
    page.AddParagraph(Plain("where"));
    page.AddFormulas(equations.locals);
  }
}

void AddPhases(const TaskParts& parts, PageBuilder& page) {
  if (parts.task.phases.empty()) return;
  page.AddHeading("Phases");
  page.Add(AutomatonOf(parts.analysis));
  Table table{{"phase", "next", "when", "meaning"}, {}};
  for (const PhaseDeclaration* phase : All<PhaseDeclaration>(parts.tree)) {
    std::vector<std::vector<Text>> rows;
    for (const ConditionalNext& next : EquationsOf(*phase).next)
      rows.push_back({{}, Code(next.phase), WhenText(next.condition), {}});
    if (phase->limit) {
      Text when = Plain("after ");
      when.push_back({Piece::kMath, ToFormula(phase->limit->time).text});
      rows.push_back({{}, Code(phase->limit->otherwise.text), std::move(when), {}});
    }
    if (rows.empty()) rows.push_back({{}, {}, {}, {}});
    rows.front().front() = Code(phase->name.text);
    rows.front().back() = FromDoc(phase->doc);
    std::ranges::move(rows, std::back_inserter(table.rows));
  }
  page.AddTable(std::move(table));
}

void AddRewards(const Statements& statements, PageBuilder& page) {
  const EventEquations& event = statements.equations;
  if (!event.terms.empty()) {
    page.AddHeading("Reward " + statements.when);
    if (!event.doc.empty()) page.AddParagraph(FromDoc(event.doc));
    page.Add(RewardFormulas(event));
  }
  if (!event.locals.empty()) {
    if (event.terms.empty()) page.AddHeading("Values " + statements.when);
    page.AddParagraph(Plain("where"));
    page.AddFormulas(event.locals);
  }
  AddSigns(event, page);
}

void AddPotentials(const TaskParts& parts, PageBuilder& page) {
  Formulas formulas;
  for (const PotentialDeclaration* potential : All<PotentialDeclaration>(parts.tree)) {
    const std::string name = TextToLatex(potential->name.text);
    formulas.lines.push_back({"\\Phi_{" + name + "}", "=", ToFormula(potential->value).text,
                              potential->name.text, ReadsOf(potential->value)});
  }
  if (formulas.lines.empty()) return;
  page.AddHeading("Potentials");
  page.Add(std::move(formulas));
  Text text = Plain("Each action is paid ");
  text.push_back({Piece::kMath, "\\gamma \\, \\Phi(s') - \\Phi(s)"});
  text.push_back({Piece::kPlain, " for the state "});
  text.push_back({Piece::kMath, "s"});
  text.push_back({Piece::kPlain, " in which it begins and "});
  text.push_back({Piece::kMath, "s'"});
  text.push_back({Piece::kPlain, " in which it ends, with the learner's discount "});
  text.push_back({Piece::kMath, "\\gamma"});
  text.push_back({Piece::kPlain, ". Where an episode ends in success or failure "});
  text.push_back({Piece::kMath, "\\Phi(s') = 0"});
  text.push_back({Piece::kPlain, ". So the policy that is best stays the best."});
  page.AddParagraph(std::move(text));
}

void AddBounds(const TaskParts& parts, PageBuilder& page) {
  if (parts.task.terms.empty()) return;
  const TaskBounds bounds = ComputeBounds(parts.task);
  Table table{{"term", "per second", "each time", "weight", "meaning"}, {}};
  for (size_t i = 0; i < parts.task.terms.size(); ++i) {
    const TermBounds& term = bounds.terms[i];
    table.rows.push_back({Code(parts.task.terms[i].name), IntervalText(term.rate),
                          IntervalText(EachTime(term)), WeightText(parts, parts.weights.terms[i]),
                          FromDoc(parts.task.terms[i].doc)});
  }
  page.AddParagraph(Plain("Bounds that follow from the ranges of the sensors and params:"));
  page.AddTable(std::move(table));
}

void AddEnds(const TaskParts& parts, PageBuilder& page) {
  Table table{{"end", "why", "when", "event"}, {}};
  for (const Statements& each : parts.statements) {
    for (const ConditionalEnd& end : each.equations.ends) {
      table.rows.push_back({Plain(std::string(WordOf(end.kind))), Plain(end.reason),
                            WhenText(end.condition), Code(each.place)});
    }
  }
  if (table.rows.empty()) return;
  page.AddHeading("An episode ends");
  page.AddTable(std::move(table));
  if (!parts.task.ended)
    page.AddParagraph(Plain("After an end, the task pays on until the episode is over."));
}

void AddRequirements(const TaskParts& parts, PageBuilder& page) {
  Table table{{"must hold", "reason", "where"}, {}};
  for (const Statements& each : parts.statements) {
    for (const ConditionalEquation& requirement : each.equations.requirements) {
      table.rows.push_back({Math(requirement.equation.right), Plain(requirement.equation.left),
                            MathOrNothing(requirement.condition)});
    }
  }
  page.AddSection("Required", std::move(table));
}

void AddMetrics(const TaskParts& parts, PageBuilder& page) {
  Table table{{"metric", "reduction", "value", "meaning"}, {}};
  for (const MetricDeclaration* metric : All<MetricDeclaration>(parts.tree)) {
    table.rows.push_back({Code(metric->name.text),
                          Plain(std::string(NameOf(metric->reduction, kReductionNames))),
                          Math(ToFormula(metric->value).text), FromDoc(metric->doc)});
  }
  page.AddSection("Metrics", std::move(table));
}

void AddLogs(const TaskParts& parts, PageBuilder& page) {
  Table table{{"log", "reduction", "value", "when"}, {}};
  for (const Statements& each : parts.statements) {
    for (const ConditionalEquation& log : each.equations.logs) {
      table.rows.push_back({Math(log.equation.left), Plain(ReductionOf(parts, log.equation.left)),
                            Math(log.equation.right), MathOrNothing(log.condition)});
    }
  }
  page.AddSection("Logs", std::move(table));
}

}  // namespace compiler
