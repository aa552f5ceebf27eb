// Sections of a task's page: what it declares, and what it reads.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "compiler/document/task_sections.h"
#include "compiler/document/value_text.h"
#include "compiler/syntax/words.h"

namespace compiler {
namespace {

// "`head`, `body`"
Text TermsText(const TaskParts& parts, const std::vector<uint32_t>& terms) {
  Text text;
  for (const uint32_t term : terms) {
    if (!text.empty()) text.push_back({Piece::kPlain, ", "});
    text.push_back({Piece::kCode, parts.task.terms[term].name});
  }
  return text;
}

Text IntervalOf(const GoalDraw& draw) {
  if (!draw.shortest) return Plain("once per episode");
  Text text = Plain("every ");
  text.push_back({Piece::kMath, ToFormula(*draw.shortest).text});
  if (!draw.longest) return text;
  text.push_back({Piece::kPlain, " to "});
  text.push_back({Piece::kMath, ToFormula(*draw.longest).text});
  return text;
}

std::string TypeOf(const TaskParts& parts, const std::string& memory) {
  const auto found = std::ranges::find(parts.task.memory, memory, &CheckedMemory::name);
  return found == parts.task.memory.end() ? "" : TypeText(found->type, found->unit);
}

// The widest of its elements'.
std::string RangeOf(const CheckedSensor& sensor) {
  if (sensor.minimum.empty() || sensor.type.scalar == Scalar::kBool) return "";
  return RangeText(std::ranges::min(sensor.minimum), std::ranges::max(sensor.maximum), sensor.unit);
}

}  // namespace

void AddParams(const TaskParts& parts, PageBuilder& page) {
  if (parts.task.params.empty()) return;
  page.AddHeading("Params");
  Table table{{"param", "type", "default", "range", "weight of", "ends episodes", "meaning"}, {}};
  for (size_t i = 0; i < parts.task.params.size(); ++i) {
    const CheckedParam& param = parts.task.params[i];
    const bool is_bool = param.type.scalar == Scalar::kBool;
    std::string initial = is_bool ? (param.initial != 0 ? "true" : "false")
                                  : WithUnit(ToText(param.initial), param.unit);
    table.rows.push_back(
        {Code(param.name), Code(ToString(param.type)), Plain(initial),
         is_bool ? Text{} : Plain(RangeText(param.minimum, param.maximum, param.unit)),
         TermsText(parts, parts.weights.params[i].scales),
         parts.weights.params[i].changes_course ? Plain("yes") : Text{}, FromDoc(param.doc)});
  }
  page.AddTable(std::move(table));
}

void AddConsts(const TaskParts& parts, PageBuilder& page) {
  Table table{{"const", "type", "value", "meaning"}, {}};
  for (const ConstDeclaration* constant : All<ConstDeclaration>(parts.tree)) {
    const auto& checked =
        *std::ranges::find(parts.task.consts, constant->name.text, &CheckedConst::name);
    table.rows.push_back({Code(checked.name), Code(TypeText(checked.type, checked.unit)),
                          Math(ToFormula(constant->value).text), FromDoc(constant->doc)});
  }
  page.AddSection("Consts", std::move(table));
}

void AddSets(const TaskParts& parts, PageBuilder& page) {
  Table table{{"set", "of", "members", "meaning"}, {}};
  for (const SetDeclaration* set : All<SetDeclaration>(parts.tree)) {
    const auto& checked = *std::ranges::find(parts.task.sets, set->name.text, &CheckedSet::name);
    table.rows.push_back(
        {Code(checked.name), Plain(checked.parts.empty() ? "numbers" : checked.parts + "s"),
         Code(fmt::format("{}", fmt::join(checked.names, ", "))), FromDoc(set->doc)});
  }
  page.AddSection("Sets", std::move(table));
}

void AddTables(const TaskParts& parts, PageBuilder& page) {
  if (parts.task.tables.empty()) return;
  page.AddHeading("Tables");
  Table table{{"table", "type", "file", "rows", "argument", "from", "to", "meaning"}, {}};
  for (const CheckedTable& each : parts.task.tables) {
    table.rows.push_back({Code(each.name), Code(TypeText(each.type, each.unit)), Code(each.file),
                          Plain(std::to_string(each.arguments.size())), Code(each.argument),
                          Plain(WithUnit(ToText(each.arguments.front()), each.argument_unit)),
                          Plain(WithUnit(ToText(each.arguments.back()), each.argument_unit)),
                          FromDoc(each.doc)});
  }
  page.AddTable(std::move(table));
}

void AddGoals(const TaskParts& parts, PageBuilder& page) {
  Table table{{"goal", "type", "drawn from", "drawn", "meaning"}, {}};
  for (const GoalDeclaration* goal : All<GoalDeclaration>(parts.tree)) {
    table.rows.push_back({Code(goal->name.text), Code(TypeOf(parts, goal->name.text)),
                          Math(ToFormula(goal->draw.value).text), IntervalOf(goal->draw),
                          FromDoc(goal->doc)});
  }
  if (table.rows.empty()) return;
  page.AddHeading("Goals");
  page.AddTable(std::move(table));
  Table redraws{{"drawn anew", "when", "event"}, {}};
  for (const Statements& each : parts.statements) {
    for (const ConditionalRedraw& redraw : each.equations.redraws) {
      redraws.rows.push_back({Code(redraw.goal), WhenText(redraw.condition), Code(each.place)});
    }
  }
  if (!redraws.rows.empty()) page.AddTable(std::move(redraws));
}

// Where each number of what the learner sees comes from.
void AddObservations(const TaskParts& parts, PageBuilder& page) {
  if (parts.task.observations.empty()) return;
  page.AddHeading("What the learner sees");
  Table table{{"numbers", "observation", "value", "type", "range", "meaning"}, {}};
  for (const ObserveDeclaration* each : All<ObserveDeclaration>(parts.tree)) {
    const auto& checked =
        *std::ranges::find(parts.task.observations, each->name.text, &CheckedObservation::name);
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
  page.AddTable(std::move(table));
  const uint32_t count = parts.task.observation_size;
  page.AddParagraph(Plain(fmt::format("{} number{} in all{}.", count, count == 1 ? "" : "s",
                                      parts.task.onboard ? ", from the robot's own sensors" : "")));
}

void AddMemory(const TaskParts& parts, PageBuilder& page) {
  Table table{{"memory", "type", "initial value", "per", "meaning"}, {}};
  for (const MemoryDeclaration* memory : All<MemoryDeclaration>(parts.tree)) {
    table.rows.push_back({Code(memory->name.text), Code(TypeOf(parts, memory->name.text)),
                          Math(ToFormula(memory->initial).text),
                          Plain(std::string(NameOf(memory->scope, kScopeNames))),
                          FromDoc(memory->doc)});
  }
  if (table.rows.empty()) return;
  page.AddHeading("Memory");
  page.AddTable(std::move(table));
  Table changes{{"becomes", "when", "event"}, {}};
  for (const Statements& each : parts.statements) {
    for (const ConditionalEquation& change : each.equations.memory) {
      changes.rows.push_back({Math(change.equation.left + " \\leftarrow " + change.equation.right),
                              WhenText(change.condition), Code(each.place)});
    }
  }
  if (!changes.rows.empty()) page.AddTable(std::move(changes));
}

void AddFunctions(const TaskParts& parts, PageBuilder& page) {
  const auto functions = All<FunctionDeclaration>(parts.tree);
  const auto is_used = [&](const FunctionDeclaration* function) {
    return std::ranges::find(parts.task.functions, function->name.text, &CheckedFunction::name) !=
           parts.task.functions.end();
  };
  if (std::ranges::none_of(functions, is_used)) return;
  page.AddHeading("Functions");
  for (const FunctionDeclaration* function : functions) {
    if (!is_used(function)) continue;
    if (!function->doc.empty()) page.AddParagraph(FromDoc(function->doc));
    page.AddFormulas(EquationsOf(*function));
  }
}

void AddSensors(const TaskParts& parts, PageBuilder& page) {
  if (parts.task.sensors.empty()) return;
  page.AddHeading("Sensors");
  Table table{{"sensor", "type", "unit", "range", "meaning"}, {}};
  for (const CheckedSensor& sensor : parts.task.sensors) {
    table.rows.push_back({Code(sensor.name), Code(ToString(sensor.type)),
                          Plain(UnitText(sensor.unit)), Plain(RangeOf(sensor)),
                          FromDoc(sensor.doc)});
  }
  page.AddTable(std::move(table));
}

void AddTests(const TaskParts& parts, PageBuilder& page) {
  const auto tests = All<TestDeclaration>(parts.tree);
  if (tests.empty()) return;
  page.AddHeading("Tests");
  List list;
  for (const TestDeclaration* test : tests) list.items.push_back(Plain(test->name));
  page.Add(std::move(list));
}

}  // namespace compiler
