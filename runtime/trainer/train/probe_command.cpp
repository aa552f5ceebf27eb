#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/text/print.h"
#include "runtime/analysis/probe/find.h"
#include "runtime/analysis/probe/probe_figures.h"
#include "runtime/analysis/probe/probe_page.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/runs/many_runs.h"
#include "runtime/trainer/setup/apart.h"
#include "runtime/trainer/setup/create_run.h"
#include "runtime/trainer/setup/made_folder.h"
#include "runtime/trainer/setup/sandbox_rules.h"
#include "runtime/trainer/setup/task_setup.h"
#include "runtime/trainer/train/prepare_runs.h"
#include "runtime/trainer/train/probe_search.h"
#include "runtime/trainer/train/probe_text.h"

namespace runtime {
namespace {

struct ProbeOptions {
  TaskOptions task;
  int searches = 4;
  uint64_t seed = 1;
  ProbeBudget budget;
  int jobs = 0;
  std::filesystem::path out;
  OutputOptions output;
};

TaskOptions WithDefaults(TaskOptions options) {
  if (options.profile.empty()) options.profile = "fast-tree";
  if (options.agent.empty()) options.agent = "motion_search";
  return options;
}

// Few coordinates are soon searched through, and cannot do everything: without other wishes every
// other search moves each joint by itself.
std::vector<TaskOptions> KindsOfSearches(const TaskOptions& options) {
  constexpr const char* kDof = "action_space.dof=";
  const bool is_chosen = !options.agent.empty() ||
                         std::ranges::any_of(options.settings, [&](const std::string& setting) {
                           return setting.starts_with(kDof);
                         });
  if (is_chosen) return {options};
  TaskOptions all_joints = options;
  all_joints.settings.push_back(std::string(kDof) + "all");
  return {options, all_joints};
}

std::filesystem::path OuterFolder(const ProbeOptions& options) {
  return options.out.empty() ? kRunsFolder : options.out;
}

std::filesystem::path FolderOf(const ProbeOptions& options, const TaskRecord& task) {
  if (!options.out.empty()) return options.out;
  return OuterFolder(options) / fmt::format("probe-{}-{}", task.task, task.task_hash.substr(0, 8));
}

// Makes the searches with these seeds that are not there yet. Returns the folder of their folders,
// then theirs.
Words PrepareSearches(const ProbeOptions& options, const TaskOptions& kind,
                      const std::vector<uint64_t>& seeds, const std::filesystem::path& plugin) {
  TaskSetup setup = SetUpInSandbox(WithDefaults(kind), plugin, options.seed, OuterFolder(options));
  const RunRecord run = RecordOf(setup, {.episodes = 1, .seed = options.seed, .record_every = 0});
  setup.graph.Start();
  const std::filesystem::path folder = FolderOf(options, run.tasks.front());
  Words found = {folder.string()};
  for (const std::filesystem::path& search :
       PrepareRuns(setup, run, seeds, folder, options.task.task.string(), "give another `--out`")) {
    found.push_back(search.string());
  }
  return found;
}

struct Searches {
  std::filesystem::path folder;
  std::vector<std::filesystem::path> runs;  // by their seeds
};

// The kinds take turns.
Searches PrepareAllSearches(const ProbeOptions& options, const std::filesystem::path& plugin) {
  const std::vector<TaskOptions> kinds = KindsOfSearches(options.task);
  const MadeFolder outer(OuterFolder(options));
  Searches searches{{}, std::vector<std::filesystem::path>(static_cast<size_t>(options.searches))};
  for (size_t kind = 0; kind < std::min(kinds.size(), searches.runs.size()); ++kind) {
    std::vector<uint64_t> seeds;
    for (size_t i = kind; i < searches.runs.size(); i += kinds.size())
      seeds.push_back(options.seed + i);
    const Words found = RunApart(options.task.task.string(), [&] {
      return PrepareSearches(options, kinds[kind], seeds, plugin);
    });
    searches.folder = found.front();
    for (size_t i = 0; i < seeds.size(); ++i) searches.runs[kind + i * kinds.size()] = found[i + 1];
  }
  return searches;
}

void Show(const ProbeResults& results, const OutputOptions& output) {
  if (output.json) {
    text::Print("{}\n", ProbeFigures(results).dump(
                            2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  } else if (!output.quiet) {
    text::Print("{}\n", ProbeText(results));
  }
}

int Probe(const ProbeOptions& options) {
  const BuiltTask task(options.task);
  if (!task.plugin()) return kFailed;
  WarnWhereSandboxIsWeak();
  const auto& [folder, runs] = PrepareAllSearches(options, *task.plugin());
  std::optional<StopRequest> stop(StopRequest::Second::kIsNoted);
  const ProbeEnd end = Search(folder, runs, options.budget, JobsOrCores(options.jobs),
                              options.output.style(), *stop);
  const int signal = stop->signal();
  stop.reset();  // from here on there is nothing to save
  const ProbeResults results = ReadProbe(folder, runs);
  Show(results, options.output);
  const std::filesystem::path page = folder / "probe.html";
  WriteProbePage(results, page);
  if (IsForPeople(options.output.style())) text::Print("{}\n", page.string());
  if (end == ProbeEnd::kStopped) return kStoppedBySignal + signal;
  return end == ProbeEnd::kDone ? kSuccess : kFailed;
}

}  // namespace

void AddProbeCommand(command_line::Command& program) {
  const auto options = std::make_shared<ProbeOptions>();
  command_line::Command& command = program.AddCommand(
      "probe", "Shows what a task pays for: the best motions that several searches find in it.");
  options->task.AddTo(command);
  command
      .AddOption("--searches", options->searches,
                 "how many, each with its own seed; every other one moves all joints by themselves")
      .Range(1, 1000)
      .ShowDefault();
  command.AddOption("--seed", options->seed, "random seed of the first search")
      .NonNegative()
      .ShowDefault();
  const command_line::Option seconds =
      command.AddOption("--seconds", options->budget.seconds, "how long to search, about")
          .Range(1, 1'000'000)
          .ShowDefault();
  command
      .AddOption("--episodes", options->budget.episodes,
                 "how many episodes of each search instead: then the same is found on any machine")
      .Range(1, 1'000'000'000)
      .Excludes(seconds);
  AddJobsOption(command, options->jobs, "how many runs to train at a time");
  command
      .AddOption("--out", options->out,
                 "folder of the searches and the page, by default runs/probe-TASK-VERSION; a probe "
                 "that is there goes on")
      .ValueName("DIR");
  options->output.AddTo(command, "what was found as one JSON object");
  AddSandboxOption(command);
  command.OnRun([options] { return Probe(*options); });
}

}  // namespace runtime
