#include "compiler/check/method_call.h"

#include <string>
#include <utility>

#include "compiler/check/builtins.h"
#include "compiler/check/names.h"
#include "compiler/check/report.h"
#include "compiler/check/type.h"
#include "compiler/check/written_form.h"
#include "compiler/syntax/foreign_words.h"

namespace compiler {
namespace {

std::string TextOf(const std::vector<Identifier>& path) {
  std::string text;
  for (const Identifier& name : path) text += (text.empty() ? "" : ".") + name.text;
  return text;
}

bool IsFunction(const std::string& name, const TaskScope& scope) {
  const Symbol* symbol = scope.symbols.Find(name);
  return FindBuiltin(name) != nullptr ||
         (symbol != nullptr && symbol->kind == SymbolKind::kFunction);
}

// The function of this language that is called like that elsewhere; empty if there is none.
std::string FunctionFor(const std::string& name, const TaskScope& scope) {
  if (IsFunction(name, scope)) return name;
  const ForeignWord* foreign = FindForeign(ForeignPlace::kFunction, name);
  return foreign != nullptr ? std::string(foreign->instead) : "";
}

// `elements`: what stands in the parentheses, which begin at `open` and end with the call.
void ReportBrackets(const std::string& array, const std::vector<ExpressionPtr>& elements, Span open,
                    Span call, const TaskScope& scope) {
  const auto written = WrittenForm(elements);
  const std::string index = "[" + (written && !elements.empty() ? *written : "...") + "]";
  Help help = fmt::format("elements are picked with brackets: `{}{}`", array, index);
  if (written && !elements.empty()) help.fixes = {{{open.begin, call.end}, index}};
  Report(scope.diagnostics, code::kUnknownFunction, {call.begin, open.begin},
         fmt::format("`{}` is not a function", array), {.help = std::move(help)});
}

void ReportModule(const std::vector<Identifier>& path, const Identifier& name,
                  const TaskScope& scope) {
  const Span span = Cover(path.front().span, name.span);
  const std::string function = FunctionFor(name.text, scope);
  Help help = HelpForForeign(ForeignPlace::kFunction, name.text, span);
  if (!function.empty()) help = WriteInstead(span, function);
  if (help.empty()) help = "functions are called by their names alone, as in `sqrt(x)`";
  Report(scope.diagnostics, code::kUnknownFunction, span,
         fmt::format("there is no function `{}.{}`", TextOf(path), name.text),
         {.help = std::move(help)});
}

}  // namespace

void ReportMethodCall(const MethodExpression& method, Span span, const TaskScope& scope) {
  const std::vector<Identifier> path = PathOf(*method.object);
  const std::string& name = method.name.text;
  const bool is_module = !path.empty() && scope.symbols.Find(path.front().text) == nullptr &&
                         FindForeign(ForeignPlace::kModule, path.front().text) != nullptr;
  if (is_module) return ReportModule(path, method.name, scope);
  const std::string whole = TextOf(path) + "." + name;
  if (scope.sensors.Find(whole) || scope.sensors.IsInvalid(whole))
    return ReportBrackets(whole, method.arguments, method.parenthesis, span, scope);
  const auto object = WrittenForm(*method.object);
  const std::string function = FunctionFor(name, scope);
  Help help = HelpForForeign(ForeignPlace::kFunction, name, method.name.span);
  help.fixes.clear();  // they are for a call without an object
  if (!function.empty()) {
    const std::string end = method.arguments.empty() ? "" : ", ";
    const std::string value = object.value_or("v");
    help = fmt::format("write `{}({}{})`", function, value, end.empty() ? "" : ", ...");
    if (object)
      help.fixes = {{Cover(method.object->span, method.parenthesis),
                     fmt::format("{}({}{}", function, *object, end)}};
  }
  Report(scope.diagnostics, code::kUnknownFunction, method.name.span,
         fmt::format("a value has no function `{}` of its own", name), {.help = std::move(help)});
}

bool ReportCalledArray(const CallExpression& call, Span span, const TaskScope& scope) {
  const std::string& name = call.function.text;
  const Symbol* symbol = scope.symbols.Find(name);
  const auto sensor = symbol == nullptr ? scope.sensors.Find(name) : std::nullopt;
  const bool has_elements = sensor ? !IsScalar(scope.sensors.list()[*sensor].type)
                                   : symbol != nullptr && symbol->is_valid &&
                                         symbol->kind != SymbolKind::kFunction &&
                                         !IsLoopVariable(*symbol) && !IsScalar(symbol->type);
  if (!has_elements) return false;
  ReportBrackets(name, call.arguments, {call.function.span.end, call.function.span.end}, span,
                 scope);
  return true;
}

}  // namespace compiler
