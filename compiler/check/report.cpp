#include "compiler/check/report.h"

#include <utility>

namespace compiler {
namespace {

constexpr size_t kLongestList = 40;

}  // namespace

void Report(Diagnostics& diagnostics, std::string_view code, Span span, std::string message,
            Explanation explanation) {
  Diagnostic diagnostic = MakeDiagnostic(code, span, std::move(message));
  diagnostic.note = std::move(explanation.note);
  diagnostic.help = std::move(explanation.help);
  diagnostic.labels = std::move(explanation.labels);
  diagnostics.Add(std::move(diagnostic));
}

std::string List(const std::vector<std::string>& names) {
  std::string text;
  for (size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " and " : ", ";
    text += fmt::format("`{}`", names[i]);
  }
  return text;
}

Help Suggest(Span span, std::string_view name, const std::vector<std::string>& valid,
             std::string_view what) {
  if (const auto nearest = text::NearestName(name, valid)) return DidYouMean(span, *nearest);
  if (valid.empty() || valid.size() > kLongestList) return "";
  return fmt::format("the {} are {}", what, List(valid));
}

}  // namespace compiler
