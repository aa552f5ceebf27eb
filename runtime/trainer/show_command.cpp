#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <span>

#include "runtime/run/progress.h"
#include "runtime/run/run_database.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/many_runs.h"
#include "runtime/workers/run_table.h"

namespace runtime {
namespace {

using Ends = std::map<std::pair<std::string, std::string>, int64_t>;  // kind and reason

// What there is to say about a run in a few lines.
struct Summary {
  RunRecord run;
  std::string state;
  std::string started_at;
  std::string finished_at;
  int64_t episodes = 0;
  ReturnStatistics returns;
  double simulated_seconds = 0;
  double wall_seconds = 0;
  int64_t faults = 0;
  int64_t violations = 0;
  TaskRecord task;              // the one that was active last
  std::vector<double> metrics;  // of this task, each one's mean over the last episodes
  std::vector<double> logs;
  Ends ends;
};

// Over those of the last episodes that have a value there and were paid by the last one's task; not
// a number where none has.
std::vector<double> LastMeans(std::span<const EpisodeRecord> episodes, size_t count,
                              std::vector<double> Evaluation::*member) {
  constexpr size_t kMeanOver = ReturnStatistics::kMeanOver;
  std::vector<double> means;
  for (size_t i = 0; i < count; ++i) {
    double sum = 0;
    int64_t values = 0;
    for (const EpisodeRecord& episode : episodes.last(std::min(episodes.size(), kMeanOver))) {
      if (episode.active.task != episodes.back().active.task) continue;
      const double value = (episode.active.*member)[i];
      if (std::isnan(value)) continue;
      sum += value;
      ++values;
    }
    means.push_back(sum / static_cast<double>(values));  // 0 / 0 without a value
  }
  return means;
}

Summary Summarise(const std::filesystem::path& folder) {
  const RunDatabase database = RunDatabase::OpenToRead(folder);
  Summary summary;
  summary.run = database.ReadRun();
  summary.state = RunStateName(database.ReadState());
  summary.started_at = database.ReadValue("started_at");
  summary.finished_at = database.ReadValue("finished_at");
  const std::vector<EpisodeRecord> episodes = database.ReadEpisodes();
  summary.task = episodes.empty() ? summary.run.tasks.front()
                                  : TaskWithId(summary.run, episodes.back().active.task);
  summary.episodes = static_cast<int64_t>(episodes.size());
  for (const EpisodeRecord& episode : episodes) {
    summary.returns.Add(episode);
    summary.simulated_seconds += episode.simulated_seconds;
    summary.wall_seconds += episode.wall_seconds;
    summary.faults += episode.active.faults;
    summary.violations += episode.active.violations;
    ++summary.ends[{episode.active.end_kind, episode.active.end_reason}];
  }
  summary.metrics = LastMeans(episodes, summary.task.metrics.size(), &Evaluation::metrics);
  summary.logs = LastMeans(episodes, summary.task.logs.size(), &Evaluation::logs);
  return summary;
}

void PrintLine(const char* name, const std::string& value) {
  fmt::print("{:<10} {}\n", name, value);
}

void PrintMeans(const char* name, const std::vector<CurveRecord>& curves,
                const std::vector<double>& means) {
  for (size_t i = 0; i < curves.size(); ++i) {
    const std::string unit = curves[i].unit.empty() ? "" : " " + curves[i].unit;
    PrintLine(name, fmt::format("{}: {:.6g}{} on average of the last {}", curves[i].name, means[i],
                                unit, ReturnStatistics::kMeanOver));
  }
}

nlohmann::ordered_json MeansByName(const std::vector<CurveRecord>& curves,
                                   const std::vector<double>& means) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (size_t i = 0; i < curves.size(); ++i) json[curves[i].name] = means[i];
  return json;
}

void PrintText(const Summary& summary) {
  const RunRecord& run = summary.run;
  PrintLine("task", fmt::format("{} ({})", summary.task.task, summary.task.task_file));
  PrintLine("robot", fmt::format("{}, profile {}", run.robot, run.profile));
  PrintLine("seed", fmt::format("{}", run.seed));
  PrintLine("state",
            fmt::format("{}, since {}", summary.state,
                        summary.finished_at.empty() ? summary.started_at : summary.finished_at));
  PrintLine("episodes", fmt::format("{} of {}", summary.episodes, run.episodes_planned));
  if (summary.episodes == 0) return;
  if (summary.returns.best_episode() > 0) {
    PrintLine("best", fmt::format("{:.6g} (episode {})", summary.returns.best(),
                                  summary.returns.best_episode()));
  }
  PrintLine("last 20", fmt::format("{:.6g} on average", summary.returns.mean()));
  PrintMeans("metric", summary.task.metrics, summary.metrics);
  PrintMeans("log", summary.task.logs, summary.logs);
  PrintLine("time", fmt::format("{} simulated in {}", DurationText(summary.simulated_seconds),
                                DurationText(summary.wall_seconds)));
  if (summary.faults > 0) {
    PrintLine("faults", fmt::format("{} reward values were not finite", summary.faults));
  }
  if (summary.violations > 0) {
    PrintLine("violations", fmt::format("{} times something that the task requires did not hold",
                                        summary.violations));
  }
  for (const auto& [end, count] : summary.ends) {
    PrintLine("ends", fmt::format("{} {}: {}", count, end.first, end.second));
  }
}

void PrintJson(const Summary& summary) {
  const RunRecord& run = summary.run;
  nlohmann::ordered_json ends = nlohmann::ordered_json::array();
  for (const auto& [end, count] : summary.ends) {
    ends.push_back({{"kind", end.first}, {"reason", end.second}, {"count", count}});
  }
  nlohmann::ordered_json json = {{"task", summary.task.task},
                                 {"task_file", summary.task.task_file},
                                 {"task_hash", summary.task.task_hash},
                                 {"robot", run.robot},
                                 {"profile", run.profile},
                                 {"agent", run.agent},
                                 {"seed", run.seed},
                                 {"state", summary.state},
                                 {"started_at", summary.started_at},
                                 {"finished_at", summary.finished_at},
                                 {"episodes", summary.episodes},
                                 {"episodes_planned", run.episodes_planned},
                                 {"simulated_seconds", summary.simulated_seconds},
                                 {"wall_seconds", summary.wall_seconds},
                                 {"faults", summary.faults},
                                 {"violations", summary.violations},
                                 {"mean_of_last_20", summary.returns.mean()},
                                 {"metrics", MeansByName(summary.task.metrics, summary.metrics)},
                                 {"logs", MeansByName(summary.task.logs, summary.logs)},
                                 {"ends", ends}};
  if (summary.returns.best_episode() > 0) {
    json["best"] = {{"episode", summary.returns.best_episode()},
                    {"return", summary.returns.best()}};
  }
  fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

std::vector<RunProgress> ProgressOf(const std::filesystem::path& folder,
                                    const std::vector<std::filesystem::path>& runs) {
  std::vector<RunProgress> progress;
  for (const std::filesystem::path& run : runs) {
    progress.push_back(ReadProgress(run, run.lexically_relative(folder).string()));
  }
  return progress;
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
  fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

void ShowMany(const std::vector<RunProgress>& runs, bool as_json) {
  if (as_json) return PrintJson(runs);
  fmt::print("{}{}\n", RunTable(runs), RunSummary(runs, 1));
}

void ShowOne(const std::filesystem::path& folder, bool as_json) {
  const Summary summary = Summarise(folder);
  as_json ? PrintJson(summary) : PrintText(summary);
}

}  // namespace

void AddShowCommand(CLI::App& app, int& status) {
  struct Options {
    std::filesystem::path folder;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "show", "Prints what a run is and how far it got; or how far all runs of a folder are.");
  command->add_option("DIR", options->folder, "folder of the run, or of many")->required();
  command->add_flag("--json", options->json, "print JSON");
  command->callback([options, &status] {
    const std::vector<std::filesystem::path> runs = FindRuns(options->folder);
    if (runs.empty() || RunDatabase::Exists(options->folder)) {
      ShowOne(options->folder, options->json);
    } else {
      ShowMany(ProgressOf(options->folder, runs), options->json);
    }
    status = kSuccess;
  });
}

}  // namespace runtime
