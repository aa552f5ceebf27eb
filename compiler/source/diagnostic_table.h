// The kinds of diagnostics, from the one list in diagnostic_table.def.
#pragma once

#include <string_view>

namespace compiler {

// The codes by name: code::kUnexpectedToken is "E0101".
namespace code {
#define DIAGNOSTIC(name, code, title) inline constexpr std::string_view name = code;
#include "compiler/source/diagnostic_table.def"
#undef DIAGNOSTIC
}  // namespace code

struct DiagnosticKind {
  std::string_view code;   // "E0101"; W for a warning
  std::string_view title;  // one line
};

inline constexpr DiagnosticKind kDiagnosticTable[] = {
#define DIAGNOSTIC(name, code, title) {code, title},
#include "compiler/source/diagnostic_table.def"
#undef DIAGNOSTIC
};

}  // namespace compiler
