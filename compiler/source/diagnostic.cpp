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

Diagnostic MakeDiagnostic(std::string_view code, Span span, std::string message) {
  Diagnostic diagnostic;
  diagnostic.severity = code.starts_with('W') ? Severity::kWarning : Severity::kError;
  diagnostic.code = code;
  diagnostic.message = std::move(message);
  diagnostic.span = span;
  return diagnostic;
}

void Diagnostics::Add(Diagnostic diagnostic) {
  assert(IsInTable(diagnostic.code));
  if (diagnostic.severity == Severity::kError) has_errors_ = true;
  const auto place = std::upper_bound(
      list_.begin(), list_.end(), diagnostic,
      [](const Diagnostic& a, const Diagnostic& b) { return a.span.begin < b.span.begin; });
  list_.insert(place, std::move(diagnostic));
}

}  // namespace compiler
