#include "compiler/document/automaton.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/source/in_one_line.h"

namespace compiler {
namespace {

std::string TextOf(Span span, const Analysis& analysis) {
  return InOneLine(analysis.sources.FileOf(span).TextOf(span));
}

std::string TextOf(const Transition::Condition& condition, const Analysis& analysis) {
  const std::string text = TextOf(condition.expression->span, analysis);
  if (condition.holds) return text;
  const auto* unary = std::get_if<CheckedUnary>(&condition.expression->node);
  if (unary != nullptr && unary->op == UnaryOperator::kNot)
    return TextOf(unary->operand->span, analysis);
  const bool is_word = text.find(' ') == std::string::npos;
  return is_word ? "not " + text : fmt::format("not ({})", text);
}

bool IsDisjunction(const CheckedExpression& condition) {
  const auto* binary = std::get_if<CheckedBinary>(&condition.node);
  return binary != nullptr && binary->op == BinaryOperator::kOr;
}

// Mermaid reads `#name;` as the character of that name.
std::string EscapedMermaid(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '"':
        escaped += "#quot;";
        break;
      case '<':
        escaped += "#lt;";
        break;
      case '>':
        escaped += "#gt;";
        break;
      case '#':
        escaped += "#35;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

}  // namespace

std::string ConditionText(const Transition& transition, const Analysis& analysis) {
  if (transition.is_limit) {
    const CheckedPhase& phase = analysis.task->phases[transition.from];
    return "after " + TextOf(phase.limit->time.span, analysis);
  }
  std::string all;
  for (const Transition::Condition& condition : transition.conditions) {
    std::string text = TextOf(condition, analysis);
    const bool is_one_of_many = transition.conditions.size() > 1;
    if (is_one_of_many && condition.holds && IsDisjunction(*condition.expression))
      text = fmt::format("({})", text);
    all += (all.empty() ? "" : " and ") + text;
  }
  return all.empty() ? "always" : all;
}

Automaton AutomatonOf(const Analysis& analysis) {
  Automaton automaton;
  for (const CheckedPhase& phase : analysis.task->phases) automaton.phases.push_back(phase.name);
  for (const Transition& transition : TransitionsOf(*analysis.task)) {
    auto way = std::ranges::find_if(automaton.ways, [&](const Automaton::Way& known) {
      return known.from == transition.from && known.to == transition.to;
    });
    if (way == automaton.ways.end())
      way = automaton.ways.insert(way, {transition.from, transition.to, {}});
    way->labels.push_back(ConditionText(transition, analysis));
  }
  return automaton;
}

std::string ToMermaid(const Automaton& automaton) {
  std::string text = "flowchart TD\n  begin(( )) --> p0\n";
  for (size_t i = 0; i < automaton.phases.size(); ++i)
    text += fmt::format("  p{}([\"{}\"])\n", i, automaton.phases[i]);
  for (const Automaton::Way& way : automaton.ways)
    for (const std::string& label : way.labels)
      text += fmt::format("  p{} -->|\"{}\"| p{}\n", way.from, EscapedMermaid(label), way.to);
  return text;
}

}  // namespace compiler
