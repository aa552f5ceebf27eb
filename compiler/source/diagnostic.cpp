#include "compiler/source/diagnostic.h"

#include <algorithm>
#include <cassert>

namespace compiler {
namespace {

[[maybe_unused]] bool IsInTable(std::string_view code) {
  return std::ranges::any_of(kDiagnosticTable,
                             [code](const DiagnosticKind& kind) { return kind.code == code; });
}

}  // namespace

Help DidYouMean(Span span, const std::string& name) {
  return {"did you mean `" + name + "`?", {{span, name}}};
}

Help WriteInstead(Span span, const std::string& text) {
  return {"write `" + text + "`", {{span, text}}};
}

Diagnostic MakeDiagnostic(std::string_view code, Span span, std::string message) {
  Diagnostic diagnostic;
  diagnostic.severity = code.starts_with('W') ? Severity::kWarning : Severity::kError;
  diagnostic.code = code;
  diagnostic.message = std::move(message);
  diagnostic.span = span;
  return diagnostic;
}

bool Diagnostics::Has(std::string_view code, Span span) const {
  const auto begin = [](const Diagnostic& other) { return other.span.begin; };
  const auto same_place = std::ranges::equal_range(list_, span.begin, {}, begin);
  return std::ranges::any_of(same_place, [&](const Diagnostic& other) {
    return other.code == code && other.span == span;
  });
}

size_t Diagnostics::error_count() const {
  return static_cast<size_t>(std::ranges::count(list_, Severity::kError, &Diagnostic::severity));
}

void Diagnostics::Add(Diagnostic diagnostic) {
  assert(IsInTable(diagnostic.code));
  if (diagnostic.severity == Severity::kError) has_errors_ = true;
  const auto begin = [](const Diagnostic& other) { return other.span.begin; };
  const auto first = std::ranges::lower_bound(list_, begin(diagnostic), {}, begin);
  const auto last = std::ranges::upper_bound(list_, begin(diagnostic), {}, begin);
  const auto says_the_same = [&](const Diagnostic& other) {
    return other.code == diagnostic.code && other.span == diagnostic.span &&
           other.message == diagnostic.message;
  };
  if (std::any_of(first, last, says_the_same)) return;
  list_.insert(last, std::move(diagnostic));
}

}  // namespace compiler
