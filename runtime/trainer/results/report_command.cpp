#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "base/text/print.h"
#include "runtime/analysis/report/report.h"
#include "runtime/analysis/study/study_document.h"
#include "runtime/analysis/study/study_report.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/runs/many_runs.h"

namespace runtime {
namespace {

struct ReportOptions {
  std::filesystem::path folder;
  std::filesystem::path output;
  std::filesystem::path document;
  bool json = false;
};

// `title`: of the document; "" for the folder's name.
void ReportStudy(const ReportOptions& options, const std::filesystem::path& folder,
                 const std::vector<std::filesystem::path>& runs, const std::string& title = "") {
  if (options.json) {
    const nlohmann::ordered_json figures = StudyFigures(folder, runs);
    text::Print("{}\n", figures.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
    return;
  }
  const bool is_page = options.document.empty();
  const std::filesystem::path file =
      is_page ? WriteStudyReport(folder, runs, options.output)
              : WriteStudyDocument(folder, runs, options.document, title);
  text::Print("{}\n", file.string());
}

// One run has a page of its own. Figures and document take it for a study that has only this one.
void ReportRun(const ReportOptions& options) {
  if (!options.json && options.document.empty()) {
    text::Print("{}\n", WriteReport(options.folder, options.output).string());
    return;
  }
  const std::filesystem::path run = std::filesystem::weakly_canonical(options.folder);
  ReportStudy(options, run.parent_path(), {run}, run.filename().string());
}

void Report(const ReportOptions& options) {
  const std::vector<std::filesystem::path> runs = FindRuns(options.folder);
  if (runs.empty()) {
    ReportRun(options);
  } else {
    ReportStudy(options, options.folder, runs);
  }
}

}  // namespace

void AddReportCommand(command_line::Command& program) {
  const auto options = std::make_shared<ReportOptions>();
  command_line::Command& command = program.AddCommand(
      "report", "Writes the report of a run, or of all runs in a folder, as one HTML file.");
  command.AddOption("DIR", options->folder, "folder of the run, or of many runs").Required();
  const command_line::Option output =
      command
          .AddOption("-o,--output", options->output, "file to write; by default report.html in DIR")
          .ValueName("FILE");
  const command_line::Option document =
      command
          .AddOption("--document", options->document,
                     "write Markdown with pictures, for a repository, into this folder instead")
          .ValueName("DIR")
          .Excludes(output);
  command.AddFlag("--json", options->json, "print the figures as JSON instead")
      .Excludes(output)
      .Excludes(document);
  command.OnRun([options] {
    Report(*options);
    return kSuccess;
  });
}

}  // namespace runtime
