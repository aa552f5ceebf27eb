#include "compiler/task_tests/test_report.h"

#include <fmt/format.h>

#include <algorithm>

namespace compiler {
namespace {

// The first line of what was written.
std::string_view WrittenAt(Span span, const Sources& sources) {
  std::string_view text = sources.FileOf(span).TextOf(span);
  return text.substr(0, text.find_first_of("\r\n"));
}

std::string ToText(const Failure& failure, const Sources& sources) {
  std::string text = fmt::format("        {}:{}: {}\n", sources.FileOf(failure.span).path(),
                                 sources.LineOf(failure.span), WrittenAt(failure.span, sources));
  if (!failure.message.empty()) text += fmt::format("            {}\n", failure.message);
  for (const SeenValue& seen : failure.values) {
    const std::string_view name = seen.name.empty() ? WrittenAt(seen.span, sources) : seen.name;
    text += fmt::format("            {} is {}\n", name, seen.value);
  }
  return text;
}

}  // namespace

size_t TestReport::failed() const {
  return static_cast<size_t>(
      std::ranges::count_if(results, [](const TestResult& result) { return !result.passed(); }));
}

std::string ToText(const TestReport& report, const Sources& sources) {
  std::string text;
  for (const TestResult& result : report.results) {
    text += fmt::format("{:<8}{}\n", result.passed() ? "ok" : "FAILED", result.name);
    for (const Failure& failure : result.failures) text += ToText(failure, sources);
  }
  return text;
}

}  // namespace compiler
