#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <set>

#include "runtime/trainer/commands.h"
#include "runtime/trainer/runs/many_runs.h"
#include "runtime/trainer/setup/create_run.h"
#include "runtime/trainer/setup/start_check.h"
#include "runtime/trainer/setup/study_file.h"
#include "runtime/trainer/train/prepare_runs.h"
#include "runtime/training/run/run_settings.h"

namespace runtime {
namespace {

struct StudyOptions {
  std::filesystem::path file;
  std::filesystem::path out;
  int jobs = 0;
  OutputOptions output;
};

// Makes the runs of an experiment that are not there yet, and returns the folders of all. `names`:
// the experiments' folders taken before.
std::vector<std::filesystem::path> Prepare(const Experiment& experiment,
                                           const std::filesystem::path& out,
                                           std::set<std::string>& names) {
  const BuiltTask task(experiment.task);
  if (!task.plugin()) throw UserError(fmt::format("{}: its task has errors", experiment.place));
  TaskSetup setup(experiment.task, *task.plugin(), experiment.seeds.front());
  const RunRecord run = RecordOf(setup, experiment.plan);
  const std::string name = experiment.name.empty() ? NameOfRuns(run) : experiment.name;
  if (!names.insert(name).second) {
    throw UserError(fmt::format("{}: two experiments are called `{}`; give this one another `name`",
                                experiment.place, name));
  }
  setup.graph.Start();
  WarnOfStart(setup);
  return PrepareRuns(setup, run, experiment.seeds, out / name, experiment.place,
                     "give this experiment another `name`");
}

int RunStudy(const StudyOptions& options) {
  const std::vector<Experiment> experiments = ReadStudy(options.file);
  const std::filesystem::path out =
      options.out.empty() ? std::filesystem::path("runs") / options.file.stem() : options.out;
  std::set<std::string> names;
  std::vector<std::filesystem::path> runs;
  for (const Experiment& experiment : experiments) {
    std::ranges::move(Prepare(experiment, out, names), std::back_inserter(runs));
  }
  return TrainRuns(out, runs, options.jobs, options.output);
}

}  // namespace

void AddStudyCommand(command_line::Command& program) {
  const auto options = std::make_shared<StudyOptions>();
  command_line::Command& command = program.AddCommand(
      "study",
      "Trains many tasks with many seeds; started again, it continues and adds what is new.");
  command.AddOption("FILE", options->file, "the study, a TOML file").Required();
  command.AddOption("--out", options->out, "folder of the runs; by default runs/FILE")
      .ValueName("DIR");
  AddJobsOption(command, options->jobs, "how many runs to train at a time");
  options->output.AddTo(command);
  command.OnRun([options] { return RunStudy(*options); });
}

}  // namespace runtime
