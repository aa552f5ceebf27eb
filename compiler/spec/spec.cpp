#include "compiler/spec/spec.h"

#include <algorithm>
#include <span>
#include <utility>

#include "compiler/check/builtins.h"
#include "compiler/check/draws.h"
#include "compiler/check/time_functions.h"
#include "compiler/check/unit.h"
#include "compiler/compose/library.h"
#include "compiler/language_server/library_text.h"
#include "compiler/language_server/vocabulary.h"
#include "compiler/source/diagnostic.h"
#include "compiler/spec/manual.h"
#include "compiler/syntax/parse.h"

namespace compiler {
namespace {

// The table of functions separates several by "` or `", as messages need it.
std::vector<std::string> UsagesIn(std::string_view text) {
  constexpr std::string_view kOr = "` or `";
  std::vector<std::string> usages;
  for (;;) {
    const size_t end = text.find(kOr);
    usages.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) return usages;
    text.remove_prefix(end + kOr.size());
  }
}

std::vector<SpecFunction> FunctionsOf(const std::string& manual) {
  std::vector<SpecFunction> functions;
  for (const std::string& name : BuiltinNames()) {
    functions.push_back(
        {name, UsagesIn(FindBuiltin(name)->usage), MeaningOf(manual, name), "function"});
  }
  for (const TimeFunctionDescription& function : kTimeFunctions) {
    functions.push_back({std::string(function.name), UsagesIn(function.usage),
                         std::string(function.doc), "of the past"});
  }
  for (const DrawDescription& draw : kDraws) {
    functions.push_back(
        {std::string(draw.name), UsagesIn(draw.usage), std::string(draw.doc), "random"});
  }
  return functions;
}

std::vector<SpecUnit> UnitsOf() {
  std::vector<SpecUnit> units;
  for (const std::string& name : KnownUnits()) {
    const ScaledUnit unit = *FindUnit(name);
    units.push_back({name, unit.ToSi(1), ToString(unit.unit)});
  }
  return units;
}

std::vector<SpecWords> WordsOf() {
  const std::pair<const char*, std::span<const ExplainedWord>> lists[] = {
      {"declarations", DeclarationWords()},
      {"events", EventWords()},
      {"statements", StatementWords()},
      {"test statements", TestWords()},
      {"values", ValueWords()},
      {"operators", OperatorWords()},
      {"reductions", ReductionWords()},
      {"scopes", ScopeWords()},
      {"outcomes", OutcomeWords()},
      {"after_end", AfterEndWords()}};
  std::vector<SpecWords> words;
  for (const auto& [what, list] : lists) {
    SpecWords& group = words.emplace_back(SpecWords{what, {}});
    for (const ExplainedWord& word : list)
      group.words.push_back({std::string(word.word), std::string(word.explanation)});
  }
  return words;
}

std::vector<SpecLibrary> LibrariesOf() {
  std::vector<SpecLibrary> libraries;
  for (const std::string& name : LibraryNames()) libraries.push_back({name, LibraryDoc(name)});
  return libraries;
}

std::string RobotOf(const SpecSources::Example& example) {
  const SourceFile source(example.name, example.text);
  Diagnostics ignored;
  const auto tree = Parse(source, ignored);
  return tree && tree->robot ? tree->robot->text : "";
}

std::vector<SpecExample> ExamplesOf(const std::string& robot, const SpecSources& sources) {
  std::vector<SpecExample> examples;
  for (const SpecSources::Example& example : sources.examples)
    examples.push_back({example.name, RobotOf(example), example.text});
  std::ranges::stable_partition(examples,
                                [&](const SpecExample& example) { return example.robot == robot; });
  if (examples.size() > kSpecExamples) examples.resize(kSpecExamples);
  return examples;
}

}  // namespace

Spec SpecOf(std::optional<robot::RobotDescription> robot, const SpecSources& sources) {
  Spec spec;
  if (robot) {
    spec.enumerations = EnumerationsOf(&*robot);
    spec.sensors = SensorCatalog::OfRobot(*robot, spec.enumerations).list();
  }
  spec.functions = FunctionsOf(sources.manual);
  spec.units = UnitsOf();
  spec.words = WordsOf();
  spec.libraries = LibrariesOf();
  spec.grammar = ReadGrammar(sources.grammar);
  spec.examples = ExamplesOf(robot ? robot->name : "", sources);
  spec.manual = sources.manual;
  spec.robot = std::move(robot);
  return spec;
}

}  // namespace compiler
