#include "compiler/check/function_call.h"

#include <utility>

#include "compiler/check/names.h"
#include "compiler/check/report.h"

namespace compiler {

std::optional<CheckedExpression> CheckFunctionCall(const FunctionSignature& function, Span span,
                                                   std::vector<Operand> arguments,
                                                   const TaskScope& scope) {
  if (!function.is_valid) return std::nullopt;
  const size_t wanted = function.parameters.size();
  if (arguments.size() != wanted) {
    Report(scope.diagnostics, code::kWrongArgumentCount, span,
           fmt::format("`{}` takes {} argument{}, not {}", function.name.text, wanted,
                       wanted == 1 ? "" : "s", arguments.size()),
           {.help = fmt::format("write `{}`", UsageOf(function)),
            .labels = {{function.name.span, "declared here"}}});
    return std::nullopt;
  }
  FunctionCall call{scope.symbols.Find(function.name.text)->index, {}};
  for (size_t i = 0; i < wanted; ++i) {
    const Local& parameter = function.parameters[i];
    auto argument = ConvertTo(std::move(arguments[i]), parameter.type, parameter.unit,
                              fmt::format("`{}` of `{}`", parameter.name, function.name.text),
                              scope.diagnostics, {{function.parameter_spans[i], "declared here"}});
    if (argument)
      call.arguments.push_back(std::make_unique<CheckedExpression>(std::move(*argument)));
  }
  if (call.arguments.size() < wanted) return std::nullopt;
  return CheckedExpression{span, function.result, function.unit, std::move(call)};
}

}  // namespace compiler
