#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "base/text/print.h"
#include "runtime/base/user_error.h"
#include "runtime/live/workers/run_table.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/results/evaluate_run.h"
#include "runtime/trainer/results/evaluation_table.h"
#include "runtime/trainer/runs/kept_run.h"
#include "runtime/trainer/runs/many_runs.h"
#include "runtime/trainer/runs/run_session.h"
#include "runtime/trainer/setup/sandbox_rules.h"
#include "runtime/trainer/setup/task_setup.h"
#include "runtime/training/run/run_database.h"

namespace runtime {
namespace {

struct EvaluateOptions {
  std::filesystem::path folder;
  EvaluationPlan plan;
  int jobs = 0;
  OutputOptions output;
};

void PrintLine(const nlohmann::ordered_json& json) {
  text::Print("{}\n", json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

int EvaluateOne(const EvaluateOptions& options) {
  const ProgressStyle style = options.output.style();
  const StopRequest stop;
  std::optional<PolicyEvaluation> evaluation = FindEvaluation(options.folder, options.plan);
  std::optional<CommandSandbox> sandbox;
  if (!evaluation) {
    const RunRecord run = RunDatabase::OpenToRead(options.folder).ReadRun();
    sandbox.emplace(RulesOf(AgentOfRun(options.folder, run), options.folder));
  }
  if (!evaluation) evaluation = EvaluateRun(options.folder, options.plan, style, stop);
  if (!evaluation) {
    if (IsForPeople(style)) {
      text::Print("stopped; an incomplete evaluation is not kept\n");
    }
    return kStoppedBySignal + stop.signal();
  }
  if (style == ProgressStyle::kJson) PrintLine(ToJson(*evaluation));
  if (IsForPeople(style)) {
    const std::string name = std::filesystem::weakly_canonical(options.folder).filename().string();
    text::Print("{}", EvaluationTable({{name, *evaluation}}));
  }
  return kSuccess;
}

// How far the evaluation of a run is.
RunProgress ProgressOf(const std::filesystem::path& run, std::string name,
                       const EvaluationPlan& plan) {
  RunProgress progress{.folder = run, .name = std::move(name), .episodes_planned = plan.episodes};
  const std::optional<PolicyEvaluation> known = FindEvaluation(run, plan);
  if (!known) return progress;
  progress.state = RunProgressState::kFinished;
  progress.episodes = plan.episodes;
  progress.last_return = known->returns.back();
  progress.best_return = *std::ranges::max_element(known->returns);
  return progress;
}

// Runs from which nothing was learned yet, or that cannot be read, are left out with a line.
std::vector<RunProgress> RunsToEvaluate(const EvaluateOptions& options,
                                        const std::vector<std::filesystem::path>& runs) {
  std::vector<RunProgress> found;
  for (const std::filesystem::path& run : runs) {
    std::string name = run.lexically_relative(options.folder).string();
    try {
      if (HasCheckpoint(run)) {
        found.push_back(ProgressOf(run, std::move(name), options.plan));
      } else {
        text::Print(stderr, "{}: left out: it has no checkpoint yet\n", name);
      }
    } catch (const UserError& error) {
      text::Print(stderr, "{}: left out: {}\n", name, error.what());
    }
  }
  if (!found.empty()) return found;
  throw UserError(fmt::format("{}: no run here has a readable checkpoint; train them first",
                              options.folder.string()));
}

void PrintAll(const std::vector<RunProgress>& runs, const EvaluationPlan& plan) {
  std::vector<NamedEvaluation> evaluations;
  for (const RunProgress& run : runs) {
    const std::filesystem::path file = EvaluationFile(run.folder, plan.profile);
    if (run.state != RunProgressState::kFinished) continue;
    evaluations.push_back({run.name, ReadEvaluation(file)});
  }
  if (!evaluations.empty()) text::Print("{}", EvaluationTable(evaluations));
}

void PrintKnownAsJson(const std::vector<RunProgress>& runs, const EvaluationPlan& plan) {
  for (const RunProgress& run : runs) {
    if (run.state != RunProgressState::kFinished) continue;
    nlohmann::ordered_json json = {{"run", run.name}};
    json.update(ToJson(ReadEvaluation(EvaluationFile(run.folder, plan.profile))));
    PrintLine(json);
  }
}

int EvaluateMany(const EvaluateOptions& options, const std::vector<std::filesystem::path>& runs) {
  const EvaluationPlan& plan = options.plan;
  const ProgressStyle style = options.output.style();
  const int jobs = JobsOrCores(options.jobs);
  const auto words = [&](const RunProgress& run) {
    std::vector<std::string> call = {"evaluate", run.folder.string(), "--episodes",
                                     std::to_string(plan.episodes), "--json"};
    if (!plan.profile.empty()) call.insert(call.end(), {"--profile", plan.profile});
    return call;
  };
  RunTablePrinter printer(style, jobs, stdout, stderr);
  Supervisor supervisor(RunsToEvaluate(options, runs), words, jobs, printer);
  if (style == ProgressStyle::kJson) PrintKnownAsJson(supervisor.runs(), plan);
  printer.Follow(supervisor.runs());
  const StopRequest stop(StopRequest::Second::kIsNoted);
  const bool are_all_finished = supervisor.Run(stop);
  printer.Erase();
  if (IsForPeople(style)) PrintAll(supervisor.runs(), plan);
  if (are_all_finished) return kSuccess;
  if (stop.signal() == 0) return kFailed;
  if (IsForPeople(style)) text::Print("stopped; the same command does the rest\n");
  return kStoppedBySignal + stop.signal();
}

void CheckProfile(const EvaluateOptions& options, const std::filesystem::path& run) {
  const bool has_profiles = !RunDatabase::OpenToRead(run).ReadRun().profile.empty();
  if (has_profiles == !options.plan.profile.empty()) return;
  if (has_profiles) throw command_line::CallError("--profile is required");
  throw command_line::CallError(fmt::format(
      "{}: the environment of this run has no profiles: leave --profile away", run.string()));
}

int Evaluate(const EvaluateOptions& options) {
  const std::vector<std::filesystem::path> runs = FindRuns(options.folder);
  CheckProfile(options, runs.empty() ? options.folder : runs.front());
  return runs.empty() ? EvaluateOne(options) : EvaluateMany(options, runs);
}

}  // namespace

void AddEvaluateCommand(command_line::Command& program) {
  const auto options = std::make_shared<EvaluateOptions>();
  command_line::Command& command =
      program.AddCommand("evaluate",
                         "Runs the learned policy of a run, or of all runs in a folder, in a "
                         "profile without learning: how much of the return remains.");
  command.AddOption("DIR", options->folder, "folder of the run, or of many runs").Required();
  AddProfileOption(command, options->plan.profile);
  command.AddOption("--episodes", options->plan.episodes, "how many episodes for each run")
      .Range(1, 1'000'000)
      .ShowDefault();
  AddJobsOption(command, options->jobs, "how many runs to evaluate at a time");
  options->output.AddTo(command, "one JSON object per episode and one per run");
  AddSandboxOption(command);
  command.OnRun([options] { return Evaluate(*options); });
}

}  // namespace runtime
