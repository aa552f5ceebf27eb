#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "runtime/report/report.h"
#include "runtime/run/run_database.h"
#include "runtime/study/study_document.h"
#include "runtime/study/study_report.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/many_runs.h"

namespace runtime {
namespace {

struct ReportOptions {
  std::filesystem::path folder;
  std::filesystem::path output;
  std::filesystem::path document;
  bool json = false;
};

struct StudyFolders {
  std::filesystem::path folder;
  std::vector<std::filesystem::path> runs;
};

// One run is a study that has only this one.
StudyFolders FoldersOf(const std::filesystem::path& folder, bool is_one) {
  if (!is_one) return {folder, FindRuns(folder)};
  const std::filesystem::path run = std::filesystem::weakly_canonical(folder);
  return {run.parent_path(), {run}};
}

void Report(const ReportOptions& options) {
  const bool is_one = RunDatabase::Exists(options.folder) || FindRuns(options.folder).empty();
  const StudyFolders study = FoldersOf(options.folder, is_one);
  if (options.json) {
    const nlohmann::ordered_json figures = StudyFigures(study.folder, study.runs);
    fmt::print("{}\n", figures.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
    return;
  }
  std::filesystem::path file;
  if (!options.document.empty()) {
    file = WriteStudyDocument(study.folder, study.runs, options.document);
  } else if (is_one) {
    file = WriteReport(options.folder, options.output);
  } else {
    file = WriteStudyReport(study.folder, study.runs, options.output);
  }
  fmt::print("{}\n", file.string());
}

}  // namespace

void AddReportCommand(CLI::App& app, int& status) {
  const auto options = std::make_shared<ReportOptions>();
  CLI::App* command = app.add_subcommand(
      "report", "Writes the report of a run, or of all runs of a folder, as one HTML file.");
  command->add_option("DIR", options->folder, "folder of the run, or of many")->required();
  CLI::Option* output = command->add_option("-o,--output", options->output,
                                            "file to write; otherwise report.html in DIR");
  CLI::Option* document =
      command
          ->add_option("--document", options->document,
                       "write Markdown with pictures into this folder instead: for a repository")
          ->excludes(output);
  command->add_flag("--json", options->json, "print the figures as JSON instead")
      ->excludes(output)
      ->excludes(document);
  command->callback([options, &status] {
    Report(*options);
    status = kSuccess;
  });
}

}  // namespace runtime
