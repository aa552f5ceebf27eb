#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/text/print.h"
#include "runtime/live/workers/run_table.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/results/run_overview.h"
#include "runtime/trainer/runs/many_runs.h"

namespace runtime {
namespace {

void Print(const nlohmann::ordered_json& json) {
  text::Print("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

void PrintJson(const std::vector<RunProgress>& runs) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const RunProgress& run : runs) {
    json.push_back({{"run", run.name},
                    {"state", NameOf(run.state)},
                    {"episodes", run.episodes},
                    {"episodes_planned", run.episodes_planned}});
    if (run.episodes > 0) {
      json.back()["last_return"] = run.last_return;
      json.back()["best_return"] = run.best_return;
    }
  }
  Print(json);
}

void ShowMany(const std::vector<RunProgress>& runs, bool as_json) {
  if (as_json) return PrintJson(runs);
  text::Print("{}{}\n", RunTable(runs), RunSummary(runs, 1));
}

void ShowOne(const std::filesystem::path& folder, bool as_json) {
  const RunOverview overview = ReadOverview(folder);
  if (as_json) return Print(OverviewJson(overview));
  text::Print("{}", OverviewText(overview));
}

struct ShowOptions {
  std::filesystem::path folder;
  bool json = false;
};

int Show(const ShowOptions& options) {
  WarnOfUnfinishedRuns(options.folder);
  const std::vector<std::filesystem::path> runs = FindRuns(options.folder);
  if (runs.empty()) {
    ShowOne(options.folder, options.json);
    return kSuccess;
  }
  const std::vector<RunProgress> progress = ReadProgressOrFailures(options.folder, runs);
  ShowMany(progress, options.json);
  const bool is_each_readable =
      std::ranges::find(progress, RunProgressState::kFailed, &RunProgress::state) == progress.end();
  return is_each_readable ? kSuccess : kFailed;
}

}  // namespace

void AddShowCommand(command_line::Command& program) {
  const auto options = std::make_shared<ShowOptions>();
  command_line::Command& command = program.AddCommand(
      "show", "Prints what a run is and how far it got, or the progress of all runs in a folder.");
  command.AddOption("DIR", options->folder, "folder of the run, or of many runs").Required();
  command.AddFlag("--json", options->json, "print JSON");
  command.OnRun([options] { return Show(*options); });
}

}  // namespace runtime
