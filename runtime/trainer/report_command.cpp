#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "runtime/report/report.h"
#include "runtime/run/run_database.h"
#include "runtime/study/study_report.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/many_runs.h"

namespace runtime {
namespace {

struct ReportOptions {
  std::filesystem::path folder;
  std::filesystem::path output;
  bool json = false;
};

// Of one run as of a study that has only this one.
nlohmann::ordered_json FiguresOfOne(const std::filesystem::path& folder) {
  const std::filesystem::path run = std::filesystem::weakly_canonical(folder);
  return StudyFigures(run.parent_path(), {run});
}

void Report(const ReportOptions& options) {
  const std::vector<std::filesystem::path> runs = FindRuns(options.folder);
  const bool is_one = runs.empty() || RunDatabase::Exists(options.folder);
  if (options.json) {
    const nlohmann::ordered_json figures =
        is_one ? FiguresOfOne(options.folder) : StudyFigures(options.folder, runs);
    fmt::print("{}\n", figures.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  } else {
    const std::filesystem::path file = is_one
                                           ? WriteReport(options.folder, options.output)
                                           : WriteStudyReport(options.folder, runs, options.output);
    fmt::print("{}\n", file.string());
  }
}

}  // namespace

void AddReportCommand(CLI::App& app, int& status) {
  const auto options = std::make_shared<ReportOptions>();
  CLI::App* command = app.add_subcommand(
      "report", "Writes the report of a run, or of all runs of a folder, as one HTML file.");
  command->add_option("DIR", options->folder, "folder of the run, or of many")->required();
  CLI::Option* output = command->add_option("-o,--output", options->output,
                                            "file to write; otherwise report.html in DIR");
  command->add_flag("--json", options->json, "print the figures as JSON instead")->excludes(output);
  command->callback([options, &status] {
    Report(*options);
    status = kSuccess;
  });
}

}  // namespace runtime
