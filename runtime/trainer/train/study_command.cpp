#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "base/text/print.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/engines/slurm_engine.h"
#include "runtime/trainer/engines/study_status.h"
#include "runtime/trainer/runs/many_runs.h"
#include "runtime/trainer/setup/apart.h"
#include "runtime/trainer/setup/create_run.h"
#include "runtime/trainer/setup/made_folder.h"
#include "runtime/trainer/setup/sandbox_rules.h"
#include "runtime/trainer/setup/start_check.h"
#include "runtime/trainer/setup/study_file.h"
#include "runtime/trainer/train/prepare_runs.h"
#include "runtime/training/run/run_settings.h"

namespace runtime {
namespace {

constexpr const char* kStatus = "status";
constexpr const char* kLocal = "local";
constexpr const char* kSlurm = "slurm";

struct StudyOptions {
  std::filesystem::path file;    // or the word kStatus
  std::filesystem::path folder;  // of a study, behind that word
  std::filesystem::path out;
  std::string engine = kLocal;
  SlurmSettings slurm;
  int jobs = 0;
  OutputOptions output;
};

// Makes the runs of an experiment that are not there yet, and returns its name, then the folders of
// all. `names`: the experiments' folders taken before.
Words Prepare(const Experiment& experiment, const std::filesystem::path& plugin,
              const std::filesystem::path& out, const std::set<std::string>& names) {
  TaskSetup setup = SetUpInSandbox(experiment.task, plugin, experiment.seeds.front(), out);
  const RunRecord run = RecordOf(setup, experiment.plan);
  const std::string name = experiment.name.empty() ? NameOfRuns(run) : experiment.name;
  if (names.contains(name)) {
    throw UserError(fmt::format("{}: two experiments are called `{}`; give this one another `name`",
                                experiment.place, name));
  }
  setup.graph.Start();
  WarnOfStart(setup);
  Words found = {name};
  for (const std::filesystem::path& folder :
       PrepareRuns(setup, run, experiment.seeds, out / name, experiment.place,
                   "give this experiment another `name`")) {
    found.push_back(folder.string());
  }
  return found;
}

// The same in a process of its own: this one starts others, and so is in no sandbox.
std::vector<std::filesystem::path> PrepareApart(const Experiment& experiment,
                                                const std::filesystem::path& out,
                                                std::set<std::string>& names) {
  const BuiltTask task(experiment.task);
  if (!task.plugin()) throw UserError(fmt::format("{}: its task has errors", experiment.place));
  const Words found = RunApart(experiment.task.task.string(),
                               [&] { return Prepare(experiment, *task.plugin(), out, names); });
  names.insert(found.front());
  return {found.begin() + 1, found.end()};
}

std::unique_ptr<Engine> EngineOf(const StudyOptions& options, const SlurmSettings& slurm) {
  if (options.engine == kSlurm) return MakeSlurmEngine(slurm.OverriddenBy(options.slurm));
  return MakeLocalEngine(options.jobs);
}

int TrainStudy(const StudyOptions& options) {
  const StudyPlan study = ReadStudy(options.file);
  const std::filesystem::path out =
      options.out.empty() ? std::filesystem::path(kRunsFolder) / options.file.stem() : options.out;
  WarnWhereSandboxIsWeak();
  const MadeFolder folder(out);
  std::set<std::string> names;
  std::vector<std::filesystem::path> runs;
  for (const Experiment& experiment : study.experiments) {
    std::ranges::move(PrepareApart(experiment, out, names), std::back_inserter(runs));
  }
  return EngineOf(options, study.slurm)->Train({out, runs}, options.output);
}

int ShowStatus(const StudyOptions& options) {
  if (options.folder.empty()) {
    throw command_line::CallError("`trainer study status` needs the folder of a study");
  }
  const std::vector<RunStatus> runs = ReadStudyStatus(options.folder);
  if (options.output.json) {
    text::Print("{}\n",
                StatusJson(runs).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  } else {
    text::Print("{}", StatusText(runs));
  }
  return kSuccess;
}

int RunStudy(const StudyOptions& options) {
  if (options.file == kStatus) return ShowStatus(options);
  if (!options.folder.empty()) {
    throw command_line::CallError(
        fmt::format("what is `{}`? Only `trainer study status` takes a "
                    "folder",
                    options.folder.string()));
  }
  return TrainStudy(options);
}

}  // namespace

void AddStudyCommand(command_line::Command& program) {
  const auto options = std::make_shared<StudyOptions>();
  command_line::Command& command = program.AddCommand(
      "study",
      "Trains many tasks with many seeds; started again, it continues and adds what is new.");
  command
      .AddOption("FILE", options->file,
                 "the study, a TOML file; or `status`, which shows how far the runs in DIR are")
      .Required();
  command.AddOption("DIR", options->folder, "folder of a study, for `status`");
  command.AddOption("--out", options->out, "folder of the runs; by default runs/FILE")
      .ValueName("DIR");
  command
      .AddOption("--engine", options->engine,
                 "who trains the runs: this machine, until they are finished, or a cluster that is "
                 "given those that are not")
      .OneOf({kLocal, kSlurm})
      .ShowDefault();
  AddJobsOption(command, options->jobs, "how many runs to train on this machine at a time");
  options->slurm.AddTo(command);
  options->output.AddTo(command);
  AddSandboxOption(command);
  command.OnRun([options] { return RunStudy(*options); });
}

}  // namespace runtime
