// The function that a call names.
#include "compiler/check/builtins.h"
#include "compiler/check/draws.h"
#include "compiler/check/names.h"
#include "compiler/check/report.h"
#include "compiler/check/time_functions.h"
#include "compiler/check/unknown_names.h"
#include "compiler/syntax/foreign_words.h"

namespace compiler {

const FunctionSignature* ResolveFunction(const Identifier& name, const Place& place,
                                         const TaskScope& scope) {
  const Symbol* symbol = scope.symbols.Find(name.text);
  if (symbol != nullptr && symbol->kind == SymbolKind::kFunction) {
    NoteReference(name, *symbol, scope);
    if (!place.is_constant()) return &scope.functions[symbol->index];
    NotConstant(name.text, name.span, place, scope);
    return nullptr;
  }
  if (symbol != nullptr) {
    Report(scope.diagnostics, code::kUnknownFunction, name.span,
           fmt::format("`{}` is {}, not a function", name.text, WhatIs(symbol->kind)),
           {.labels = {{symbol->span, "declared here"}}});
    return nullptr;
  }
  if (!scope.knows_functions || scope.refused.contains(name.text)) return nullptr;
  std::vector<std::string> functions = BuiltinNames();
  for (const FunctionSignature& function : scope.functions) functions.push_back(function.name.text);
  for (const TimeFunctionDescription& each : kTimeFunctions) functions.emplace_back(each.name);
  for (const CheckedTable& table : scope.constants.tables) functions.push_back(table.name);
  if (place.kind == Place::kExpect)
    for (const std::string_view of_test : kTestFunctions) functions.emplace_back(of_test);
  if (IsDrawFunction(name.text)) {
    Report(scope.diagnostics, code::kMisplacedDraw, name.span,
           fmt::format("`{}` draws a random number, which only goals and starts do", name.text),
           {.help = "declare a goal and read it here: `goal NAME: TYPE = ...`"});
    return nullptr;
  }
  Help help = HelpForForeign(ForeignPlace::kFunction, name.text, name.span);
  if (help.empty()) help = Suggest(name.span, name.text, functions, "functions");
  if (help.empty()) help = fmt::format("the functions are {}", List(functions));
  if (IsTestFunction(name.text)) help = "it is known only after the `expect` of a test";
  if (help.fixes.empty() && !scope.reported.insert(name.text).second) return nullptr;
  Report(scope.diagnostics, code::kUnknownFunction, name.span,
         fmt::format("there is no function `{}`{}", name.text,
                     IsTestFunction(name.text) ? " here" : ""),
         {.help = std::move(help)});
  return nullptr;
}

std::string UsageOf(const FunctionSignature& function) {
  std::string parameters;
  for (const Local& parameter : function.parameters)
    parameters += (parameters.empty() ? "" : ", ") + parameter.name;
  return fmt::format("{}({})", function.name.text, parameters);
}

}  // namespace compiler
