#include "compiler/driver/session.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace compiler {
namespace {

// The custom of no-color.org: any value but an empty one counts.
bool WantsColor() {
  const char* no_color = std::getenv("NO_COLOR");
  return isatty(STDERR_FILENO) != 0 && (no_color == nullptr || *no_color == '\0');
}

std::string Count(int count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace

Session::Session() : color_(WantsColor()) {}

Analysis Session::Analyze(const std::string& file) {
  Analysis analysis = compiler::Analyze(file, ReadFromDisk, robots);
  Report(analysis.source, analysis.diagnostics);
  return analysis;
}

void Session::Report(const SourceFile& source, const Diagnostics& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    ++(diagnostic.severity == Severity::kError ? errors_ : warnings_);
  }
  fmt::print(stderr, "{}", Render(source, diagnostics, color_));
}

void Session::Finish() const {
  std::string summary;
  if (errors_ > 0) summary += Count(errors_, "error");
  if (errors_ > 0 && warnings_ > 0) summary += ", ";
  if (warnings_ > 0) summary += Count(warnings_, "warning");
  if (!summary.empty()) fmt::print(stderr, "{}\n", summary);
}

}  // namespace compiler
