#include "compiler/driver/session.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "base/text/print.h"
#include "compiler/driver/crash_report.h"
#include "compiler/driver/print_error.h"

namespace compiler {
namespace {

bool WantsColor(const std::string& wish) {
  if (wish != "auto") return wish == "always";
  // The custom of no-color.org: any value but an empty one counts.
  const char* no_color = std::getenv("NO_COLOR");
  return isatty(STDERR_FILENO) != 0 && (no_color == nullptr || *no_color == '\0');
}

std::string Count(size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::optional<std::string> ReadAndRemember(const std::filesystem::path& file) {
  RememberFile(file);
  return ReadFromDisk(file);
}

// Reads `text` in the place of `task`.
FileReader ReaderOf(const std::string& task, const std::filesystem::path& text) {
  if (text.empty()) return ReadAndRemember;
  return [task, text](const std::filesystem::path& file) {
    return ReadAndRemember(file == task ? text : file);
  };
}

// "2 errors, 1 warning"
std::string Counts(size_t errors, size_t warnings) {
  if (warnings == 0) return Count(errors, "error");
  if (errors == 0) return Count(warnings, "warning");
  return Count(errors, "error") + ", " + Count(warnings, "warning");
}

}  // namespace

Analysis Session::Analyze(const std::string& file) {
  Analysis analysis = compiler::Analyze(file, ReaderOf(file, text_file), robots);
  Report(analysis.sources, analysis.diagnostics);
  if (analysis.task) Result()["name"] = analysis.task->name;
  return analysis;
}

void Session::Report(const Sources& sources, const Diagnostics& diagnostics) {
  report_.Add(sources, diagnostics);
  Json files = Json::array();
  for (const SourceFile& file : sources.files()) files.push_back(file.path());
  report_.tasks.push_back({{"file", sources.main().path()},
                           {"ok", !diagnostics.has_errors()},
                           {"files", std::move(files)}});
  if (is_for_a_person()) {
    fmt::print(stderr, "{}", Render(sources, diagnostics, WantsColor(color)));
  }
}

void Session::Say(std::string_view text) const {
  if (is_for_a_person()) text::Print("{}", text);
}

Json& Session::Result() { return report_.tasks.back(); }

void Session::Fail(const std::string& message) {
  PrintError(message);
  report_.failures.push_back(message);
}

void Session::Finish(ExitStatus status) {
  report_.exit_status = static_cast<int>(status);
  if (is_for_a_person()) {
    PrintSummary();
  } else {
    text::Print("{}", ToText(format == "json" ? ToJson(report_) : ToSarif(report_)));
  }
}

void Session::PrintSummary() const {
  if (report_.findings.empty()) return;
  const auto is_error = [](const RunReport::Finding& finding) {
    return finding.diagnostic.severity == Severity::kError;
  };
  const auto errors = static_cast<size_t>(std::ranges::count_if(report_.findings, is_error));
  const auto error = std::ranges::find_if(report_.findings, is_error);
  const auto& telling = error != report_.findings.end() ? *error : report_.findings.front();
  text::Print(stderr, "{}; for more: taskc explain {}\n",
              Counts(errors, report_.findings.size() - errors), telling.diagnostic.code);
}

}  // namespace compiler
