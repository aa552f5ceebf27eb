#include "compiler/document/task_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

#include "compiler/bounds/bounds.h"
#include "compiler/check/unit.h"
#include "compiler/document/automaton.h"
#include "compiler/document/equations.h"
#include "compiler/document/reads.h"
#include "compiler/syntax/words.h"
#include "compiler/weights/weights.h"

namespace compiler {
namespace {

// Without a place to break the line.
std::string UnitText(const Unit& unit) {
  std::string text = ToString(unit);
  for (size_t at; (at = text.find(' ')) != std::string::npos;) text.replace(at, 1, "\u00a0");
  return text;
}

std::string WithUnit(const std::string& text, const Unit& unit) {
  const std::string name = UnitText(unit);
  return name.empty() ? text : text + "\u00a0" + name;
}

std::string ToText(double value) {
  if (std::isinf(value)) return value < 0 ? "-∞" : "∞";
  // -0 is no news to anybody.
  return fmt::format("{:.6g}", value == 0 ? 0.0 : value);
}

std::string RangeText(double low, double high, const Unit& unit) {
  if (std::isinf(low) && std::isinf(high)) return "";
  return WithUnit(ToText(low) + " .. " + ToText(high), unit);
}

std::string_view WordOf(EndKind kind) {
  const std::string_view outcome = NameOf(kind, kOutcomeNames);
  return outcome.empty() ? "truncated" : outcome;
}

// "the end of a time step" for `end_of_time_step`.
std::string InWords(std::string event) {
  std::ranges::replace(event, '_', ' ');
  const size_t of = event.find(" of ") + 4;
  const bool has_vowel = event[of] == 'e' || event[of] == 'a';
  return "the " + event.insert(of, has_vowel ? "an " : "a ");
}

// A formula as a cell; empty where there is none.
Text MathOrNothing(const std::string& latex) { return latex.empty() ? Text{} : Math(latex); }

// The declarations of one kind, in the order of the file.
template <typename Node>
std::vector<const Node*> All(const SyntaxTree& tree) {
  std::vector<const Node*> nodes;
  for (const Declaration& declaration : tree.declarations) {
    if (const auto* node = std::get_if<Node>(&declaration.node)) nodes.push_back(node);
  }
  return nodes;
}

class PageWriter {
 public:
  explicit PageWriter(const Analysis& analysis)
      : analysis_(analysis),
        task_(*analysis.task),
        tree_(*analysis.tree),
        weights_(FindWeights(task_)) {
    for (const EventDeclaration* event : All<EventDeclaration>(tree_))
      statements_.push_back(
          {EquationsOf(*event), event->name.text, "at " + InWords(event->name.text)});
    for (const PhaseDeclaration* phase : All<PhaseDeclaration>(tree_))
      statements_.push_back(
          {EquationsOf(*phase), "phase " + phase->name.text, "in the phase " + phase->name.text});
  }

  Page Write() {
    page_.title = task_.name;
    Introduction();
    Start();
    Phases();
    for (const Statements& each : statements_) Rewards(each);
    Potentials();
    Bounds();
    Ends();
    Requirements();
    Metrics();
    Params();
    Consts();
    Sets();
    Tables();
    Goals();
    Observations();
    Memory();
    Logs();
    Functions();
    Sensors();
    Tests();
    return std::move(page_);
  }

 private:
  // What an event or a phase does.
  struct Statements {
    EventEquations equations;
    std::string place;  // "end_of_time_step", "phase lift"
    std::string when;   // "at the end of a time step", "in the phase lift"
  };

  void Introduction() {
    std::istringstream lines(task_.doc);
    std::string paragraph;
    const auto flush = [&] {
      if (!paragraph.empty()) page_.blocks.push_back(Paragraph{FromDoc(paragraph)});
      paragraph.clear();
    };
    for (std::string line; std::getline(lines, line);) {
      if (line.empty()) {
        flush();
      } else {
        paragraph += (paragraph.empty() ? "" : " ") + line;
      }
    }
    flush();
    Text facts;
    if (task_.robot.empty()) {
      facts = Plain("For any host that supplies the sensors below.");
    } else {
      facts = {{Piece::kPlain, "Robot: "}, {Piece::kCode, task_.robot}};
      const std::vector<std::string>& poses = task_.start.poses;
      for (size_t i = 0; i < poses.size(); ++i) {
        facts.push_back({Piece::kPlain, i == 0 ? ", which starts in the pose " : " or "});
        facts.push_back({Piece::kCode, poses[i]});
      }
      if (tree_.world) {
        facts.push_back({Piece::kPlain, ", in the world "});
        facts.push_back({Piece::kCode, tree_.world->path});
      }
      facts.push_back({Piece::kPlain, "."});
    }
    page_.blocks.push_back(Paragraph{facts});
  }

  void Phases() {
    if (task_.phases.empty()) return;
    AddHeading("Phases");
    page_.blocks.push_back(AutomatonOf(analysis_));
    Table table{{"phase", "next", "when", "meaning"}, {}};
    for (const PhaseDeclaration* phase : All<PhaseDeclaration>(tree_)) {
      std::vector<std::vector<Text>> rows;
      for (const ConditionalNext& next : EquationsOf(*phase).next)
        rows.push_back({{},
                        Code(next.phase),
                        next.condition.empty() ? Plain("always") : Math(next.condition),
                        {}});
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
    AddTable(std::move(table));
  }

  // What is drawn where an episode begins.
  void Start() {
    for (const StartDeclaration* start : All<StartDeclaration>(tree_)) {
      const StartEquations equations = EquationsOf(*start);
      if (equations.values.empty()) continue;
      AddHeading("Start of an episode");
      Table table{{"becomes", "when"}, {}};
      for (const ConditionalEquation& value : equations.values) {
        table.rows.push_back({Math(value.equation.left + " \\leftarrow " + value.equation.right),
                              value.condition.empty() ? Plain("always") : Math(value.condition)});
      }
      AddTable(std::move(table));
      if (equations.locals.empty()) continue;
      page_.blocks.push_back(Paragraph{Plain("where")});
      AddFormulas(equations.locals);
    }
  }

  void Rewards(const Statements& statements) {
    const EventEquations& event = statements.equations;
    if (!event.terms.empty()) {
      AddHeading("Reward " + statements.when);
      if (!event.doc.empty()) page_.blocks.push_back(Paragraph{FromDoc(event.doc)});
      page_.blocks.push_back(RewardFormulas(event));
    }
    if (!event.locals.empty()) {
      if (event.terms.empty()) AddHeading("Values " + statements.when);
      page_.blocks.push_back(Paragraph{Plain("where")});
      AddFormulas(event.locals);
    }
    Signs(event);
  }

  static Formulas RewardFormulas(const EventEquations& event) {
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

  void Potentials() {
    Formulas formulas;
    for (const PotentialDeclaration* potential : All<PotentialDeclaration>(tree_)) {
      const std::string name = TextToLatex(potential->name.text);
      formulas.lines.push_back({"\\Phi_{" + name + "}", "=", ToFormula(potential->value).text,
                                potential->name.text, ReadsOf(potential->value)});
    }
    if (formulas.lines.empty()) return;
    AddHeading("Potentials");
    page_.blocks.push_back(std::move(formulas));
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
    page_.blocks.push_back(Paragraph{std::move(text)});
  }

  // Says what the signs of the formulas above mean.
  void Signs(const EventEquations& event) {
    const auto contains = [&](std::string_view sign) {
      return std::ranges::any_of(event.terms, [&](const TermEquation& term) {
        return term.equation.right.find(sign) != std::string::npos;
      });
    };
    if (!contains("\\Delta t")) return;
    Text text = Math("\\Delta t");
    text.push_back({Piece::kPlain, " is the length of the time step."});
    page_.blocks.push_back(Paragraph{std::move(text)});
  }

  void Bounds() {
    if (task_.terms.empty()) return;
    const TaskBounds bounds = ComputeBounds(task_);
    Table table{{"term", "per second", "each time", "weight", "meaning"}, {}};
    for (size_t i = 0; i < task_.terms.size(); ++i) {
      const TermBounds& term = bounds.terms[i];
      table.rows.push_back({Code(task_.terms[i].name), IntervalText(term.rate),
                            IntervalText(EachTime(term)), WeightText(weights_.terms[i]),
                            FromDoc(task_.terms[i].doc)});
    }
    page_.blocks.push_back(
        Paragraph{Plain("Bounds that follow from the ranges of the sensors and params:")});
    AddTable(std::move(table));
  }

  static Text IntervalText(const std::optional<Interval>& interval) {
    if (!interval) return {};
    return Plain(ToText(interval->low) + " .. " + ToText(interval->high));
  }

  // A potential pays each action.
  static std::optional<Interval> EachTime(const TermBounds& term) {
    return term.potential ? PaymentOfPotential(*term.potential) : term.payment;
  }

  Text WeightText(std::optional<uint32_t> param) const {
    return param ? Code(task_.params[*param].name) : Text{};
  }

  void Ends() {
    Table table{{"end", "why", "when", "event"}, {}};
    for (const Statements& each : statements_) {
      for (const ConditionalEnd& end : each.equations.ends) {
        table.rows.push_back({Plain(std::string(WordOf(end.kind))), Plain(end.reason),
                              end.condition.empty() ? Plain("always") : Math(end.condition),
                              Code(each.place)});
      }
    }
    if (table.rows.empty()) return;
    AddHeading("An episode ends");
    AddTable(std::move(table));
    if (!task_.ended)
      page_.blocks.push_back(
          Paragraph{Plain("After an end, the task pays on until the episode is over.")});
  }

  void Requirements() {
    Table table{{"must hold", "reason", "where"}, {}};
    for (const Statements& each : statements_) {
      for (const ConditionalEquation& requirement : each.equations.requirements) {
        table.rows.push_back({Math(requirement.equation.right), Plain(requirement.equation.left),
                              MathOrNothing(requirement.condition)});
      }
    }
    if (table.rows.empty()) return;
    AddHeading("Required");
    AddTable(std::move(table));
  }

  void Metrics() {
    Table table{{"metric", "reduction", "value", "meaning"}, {}};
    for (const MetricDeclaration* metric : All<MetricDeclaration>(tree_)) {
      table.rows.push_back({Code(metric->name.text),
                            Plain(std::string(NameOf(metric->reduction, kReductionNames))),
                            Math(ToFormula(metric->value).text), FromDoc(metric->doc)});
    }
    if (table.rows.empty()) return;
    AddHeading("Metrics");
    AddTable(std::move(table));
  }

  void Params() {
    if (task_.params.empty()) return;
    AddHeading("Params");
    Table table{{"param", "type", "default", "range", "weight of", "ends episodes", "meaning"}, {}};
    for (size_t i = 0; i < task_.params.size(); ++i) {
      const CheckedParam& param = task_.params[i];
      const bool is_bool = param.type.scalar == Scalar::kBool;
      std::string initial = is_bool ? (param.initial != 0 ? "true" : "false")
                                    : WithUnit(ToText(param.initial), param.unit);
      table.rows.push_back(
          {Code(param.name), Code(ToString(param.type)), Plain(initial),
           is_bool ? Text{} : Plain(RangeText(param.minimum, param.maximum, param.unit)),
           TermsText(weights_.params[i].scales),
           weights_.params[i].changes_course ? Plain("yes") : Text{}, FromDoc(param.doc)});
    }
    AddTable(std::move(table));
  }

  void Consts() {
    Table table{{"const", "type", "value", "meaning"}, {}};
    for (const ConstDeclaration* constant : All<ConstDeclaration>(tree_)) {
      const auto& checked =
          *std::ranges::find(task_.consts, constant->name.text, &CheckedConst::name);
      table.rows.push_back({Code(checked.name), Code(TypeText(checked.type, checked.unit)),
                            Math(ToFormula(constant->value).text), FromDoc(constant->doc)});
    }
    if (table.rows.empty()) return;
    AddHeading("Consts");
    AddTable(std::move(table));
  }

  void Sets() {
    Table table{{"set", "of", "members", "meaning"}, {}};
    for (const SetDeclaration* set : All<SetDeclaration>(tree_)) {
      const auto& checked = *std::ranges::find(task_.sets, set->name.text, &CheckedSet::name);
      table.rows.push_back(
          {Code(checked.name), Plain(checked.parts.empty() ? "numbers" : checked.parts + "s"),
           Code(fmt::format("{}", fmt::join(checked.names, ", "))), FromDoc(set->doc)});
    }
    if (table.rows.empty()) return;
    AddHeading("Sets");
    AddTable(std::move(table));
  }

  void Tables() {
    if (task_.tables.empty()) return;
    AddHeading("Tables");
    Table table{{"table", "type", "file", "rows", "argument", "from", "to", "meaning"}, {}};
    for (const CheckedTable& each : task_.tables) {
      table.rows.push_back({Code(each.name), Code(TypeText(each.type, each.unit)), Code(each.file),
                            Plain(std::to_string(each.arguments.size())), Code(each.argument),
                            Plain(WithUnit(ToText(each.arguments.front()), each.argument_unit)),
                            Plain(WithUnit(ToText(each.arguments.back()), each.argument_unit)),
                            FromDoc(each.doc)});
    }
    AddTable(std::move(table));
  }

  // "`head`, `body`"
  Text TermsText(const std::vector<uint32_t>& terms) const {
    Text text;
    for (const uint32_t term : terms) {
      if (!text.empty()) text.push_back({Piece::kPlain, ", "});
      text.push_back({Piece::kCode, task_.terms[term].name});
    }
    return text;
  }

  void Goals() {
    Table table{{"goal", "type", "drawn from", "drawn", "meaning"}, {}};
    for (const GoalDeclaration* goal : All<GoalDeclaration>(tree_)) {
      table.rows.push_back({Code(goal->name.text), Code(TypeOf(goal->name.text)),
                            Math(ToFormula(goal->draw.value).text), IntervalOf(goal->draw),
                            FromDoc(goal->doc)});
    }
    if (table.rows.empty()) return;
    AddHeading("Goals");
    AddTable(std::move(table));
    Table redraws{{"drawn anew", "when", "event"}, {}};
    for (const Statements& each : statements_) {
      for (const ConditionalRedraw& redraw : each.equations.redraws) {
        redraws.rows.push_back({Code(redraw.goal),
                                redraw.condition.empty() ? Plain("always") : Math(redraw.condition),
                                Code(each.place)});
      }
    }
    if (!redraws.rows.empty()) AddTable(std::move(redraws));
  }

  static Text IntervalOf(const GoalDraw& draw) {
    if (!draw.shortest) return Plain("once per episode");
    Text text = Plain("every ");
    text.push_back({Piece::kMath, ToFormula(*draw.shortest).text});
    if (!draw.longest) return text;
    text.push_back({Piece::kPlain, " to "});
    text.push_back({Piece::kMath, ToFormula(*draw.longest).text});
    return text;
  }

  // Where each number of what the learner sees comes from.
  void Observations() {
    if (task_.observations.empty()) return;
    AddHeading("What the learner sees");
    Table table{{"numbers", "observation", "value", "type", "range", "meaning"}, {}};
    for (const ObserveDeclaration* each : All<ObserveDeclaration>(tree_)) {
      const auto& checked =
          *std::ranges::find(task_.observations, each->name.text, &CheckedObservation::name);
      const CheckedExpression& value = checked.value;
      const uint32_t last = checked.offset + value.type.size() - 1;
      const bool is_bool = value.type.scalar == Scalar::kBool;
      table.rows.push_back(
          {Plain(last == checked.offset ? fmt::format("{}", last)
                                        : fmt::format("{} .. {}", checked.offset, last)),
           checked.has_name ? Code(checked.name) : Text{}, Math(ToFormula(each->value).text),
           Code(TypeText(value.type, value.unit)),
           is_bool ? Text{} : Plain(RangeText(checked.minimum, checked.maximum, value.unit)),
           FromDoc(checked.doc)});
    }
    AddTable(std::move(table));
    const uint32_t count = task_.observation_size;
    page_.blocks.push_back(
        Paragraph{Plain(fmt::format("{} number{} in all{}.", count, count == 1 ? "" : "s",
                                    task_.onboard ? ", from the robot's own sensors" : ""))});
  }

  void Memory() {
    Table table{{"memory", "type", "initial value", "per", "meaning"}, {}};
    for (const MemoryDeclaration* memory : All<MemoryDeclaration>(tree_)) {
      table.rows.push_back({Code(memory->name.text), Code(TypeOf(memory->name.text)),
                            Math(ToFormula(memory->initial).text),
                            Plain(std::string(NameOf(memory->scope, kScopeNames))),
                            FromDoc(memory->doc)});
    }
    if (table.rows.empty()) return;
    AddHeading("Memory");
    AddTable(std::move(table));
    Table changes{{"becomes", "when", "event"}, {}};
    for (const Statements& each : statements_) {
      for (const ConditionalEquation& change : each.equations.memory) {
        changes.rows.push_back(
            {Math(change.equation.left + " \\leftarrow " + change.equation.right),
             change.condition.empty() ? Plain("always") : Math(change.condition),
             Code(each.place)});
      }
    }
    if (!changes.rows.empty()) AddTable(std::move(changes));
  }

  std::string TypeOf(const std::string& memory) const {
    const auto found = std::ranges::find(task_.memory, memory, &CheckedMemory::name);
    return found == task_.memory.end() ? "" : TypeText(found->type, found->unit);
  }

  void Logs() {
    Table table{{"log", "reduction", "value", "when"}, {}};
    for (const Statements& each : statements_) {
      for (const ConditionalEquation& log : each.equations.logs) {
        table.rows.push_back({Math(log.equation.left), Plain(ReductionOf(log.equation.left)),
                              Math(log.equation.right), MathOrNothing(log.condition)});
      }
    }
    if (table.rows.empty()) return;
    AddHeading("Logs");
    AddTable(std::move(table));
  }

  std::string ReductionOf(const std::string& latex) const {
    for (const CheckedLogValue& log : task_.logs) {
      if (NameToLatex(log.name) == latex)
        return std::string(NameOf(log.reduction, kReductionNames));
    }
    return "";
  }

  void Functions() {
    const auto functions = All<FunctionDeclaration>(tree_);
    const auto is_used = [&](const FunctionDeclaration* function) {
      return std::ranges::find(task_.functions, function->name.text, &CheckedFunction::name) !=
             task_.functions.end();
    };
    if (std::ranges::none_of(functions, is_used)) return;
    AddHeading("Functions");
    for (const FunctionDeclaration* function : functions) {
      if (!is_used(function)) continue;
      if (!function->doc.empty()) page_.blocks.push_back(Paragraph{FromDoc(function->doc)});
      AddFormulas(EquationsOf(*function));
    }
  }

  void Sensors() {
    if (task_.sensors.empty()) return;
    AddHeading("Sensors");
    Table table{{"sensor", "type", "unit", "range", "meaning"}, {}};
    for (const CheckedSensor& sensor : task_.sensors) {
      table.rows.push_back({Code(sensor.name), Code(ToString(sensor.type)),
                            Plain(UnitText(sensor.unit)), Plain(RangeOf(sensor)),
                            FromDoc(sensor.doc)});
    }
    AddTable(std::move(table));
  }

  // The widest of its elements'.
  static std::string RangeOf(const CheckedSensor& sensor) {
    if (sensor.minimum.empty() || sensor.type.scalar == Scalar::kBool) return "";
    return RangeText(std::ranges::min(sensor.minimum), std::ranges::max(sensor.maximum),
                     sensor.unit);
  }

  void Tests() {
    const auto tests = All<TestDeclaration>(tree_);
    if (tests.empty()) return;
    AddHeading("Tests");
    List list;
    for (const TestDeclaration* test : tests) list.items.push_back(Plain(test->name));
    page_.blocks.push_back(std::move(list));
  }

  void AddHeading(std::string text) { page_.blocks.push_back(Heading{2, Plain(std::move(text))}); }

  void AddFormulas(const std::vector<Equation>& equations) {
    Formulas formulas;
    for (const Equation& equation : equations) {
      formulas.lines.push_back({equation.left, "=", equation.right, "", equation.reads});
    }
    page_.blocks.push_back(std::move(formulas));
  }

  // Columns in which nothing stands are left out.
  void AddTable(Table table) {
    for (size_t column = table.header.size(); column-- > 0;) {
      const auto is_blank = [&](const std::vector<Text>& row) {
        return std::ranges::all_of(row[column], [](const Piece& p) { return p.text.empty(); });
      };
      if (!std::ranges::all_of(table.rows, is_blank)) continue;
      table.header.erase(table.header.begin() + static_cast<std::ptrdiff_t>(column));
      for (auto& row : table.rows) row.erase(row.begin() + static_cast<std::ptrdiff_t>(column));
    }
    page_.blocks.push_back(std::move(table));
  }

  const Analysis& analysis_;
  const CheckedTask& task_;
  const SyntaxTree& tree_;
  const Weights weights_;
  std::vector<Statements> statements_;
  Page page_;
};

}  // namespace

Page PageOf(const Analysis& analysis) { return PageWriter(analysis).Write(); }

}  // namespace compiler
