#include "compiler/driver/front_end.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <utility>

#include "compiler/check/check.h"
#include "compiler/driver/find_robot.h"
#include "compiler/syntax/parse.h"

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

FrontEnd::FrontEnd(std::filesystem::path robots)
    : robots_(std::move(robots)), color_(WantsColor()) {}

FrontEnd::Result FrontEnd::Check(const std::string& file) {
  SourceFile source = SourceFile::Read(file);
  Diagnostics diagnostics;
  std::optional<CheckedTask> task = CheckSource(source, diagnostics);
  Report(source, diagnostics);
  return {.source = std::move(source), .task = std::move(task)};
}

std::optional<CheckedTask> FrontEnd::CheckSource(const SourceFile& source,
                                                 Diagnostics& diagnostics) const {
  std::optional<SyntaxTree> tree = Parse(source, diagnostics);
  if (!tree) return std::nullopt;
  if (!tree->robot) return compiler::Check(*tree, source, nullptr, diagnostics);
  std::optional<robot::RobotDescription> robot =
      FindRobot(*tree->robot, source.path(), robots_, diagnostics);
  if (!robot) return std::nullopt;
  return compiler::Check(*tree, source, &*robot, diagnostics);
}

void FrontEnd::Report(const SourceFile& source, const Diagnostics& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    ++(diagnostic.severity == Severity::kError ? errors_ : warnings_);
  }
  if (!diagnostics.list().empty()) fmt::print(stderr, "{}", Render(source, diagnostics, color_));
}

std::string FrontEnd::Summary() const {
  std::string summary;
  if (errors_ > 0) summary += Count(errors_, "error");
  if (errors_ > 0 && warnings_ > 0) summary += ", ";
  if (warnings_ > 0) summary += Count(warnings_, "warning");
  return summary;
}

}  // namespace compiler
