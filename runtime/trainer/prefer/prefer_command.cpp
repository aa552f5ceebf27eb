#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/text/print.h"
#include "runtime/analysis/study/preference_figures.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/prefer/dialog.h"
#include "runtime/trainer/prefer/statements.h"
#include "runtime/trainer/prefer/text.h"
#include "runtime/trainer/prefer/write_weights.h"
#include "runtime/trainer/runs/many_runs.h"

namespace runtime {
namespace {

namespace fs = std::filesystem;

using command_line::CallError;

struct PreferOptions {
  fs::path folder;
  PreferStatements statements;
  std::string experiment;
  double factor = kExpectedFactor;
  fs::path output;
  fs::path task;
  bool is_forced = false;
  bool json = false;
};

// What follows from a user's preferences, experiment by experiment.
class PreferCommand {
 public:
  explicit PreferCommand(const PreferOptions& options)
      : options_(options), study_(Read(options.folder)) {
    if (options_.experiment.empty()) return;
    std::vector<std::string> names;
    for (const ExperimentResult& each : study_.experiments) names.push_back(each.experiment->name);
    if (std::ranges::count(names, options_.experiment) > 0) return;
    throw CallError(fmt::format("--experiment {}: there is no such experiment in {}; there are {}",
                                options_.experiment, options_.folder.string(),
                                fmt::join(names, ", ")));
  }

  void Run() {
    stated_ = NoteStatements(options_.statements, study_, options_.experiment, options_.folder);
    const bool may_ask = stated_ == nullptr && options_.output.empty() && !options_.json;
    if (may_ask && isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0) AskAll();
    const std::vector<PreferenceFit> fits = FitAll();
    if (!options_.json) Print(fits);
    const std::vector<fs::path> written = WriteTask(fits);
    if (options_.json) PrintJson(fits, written);
  }

 private:
  static StudyResults Read(const fs::path& folder) {
    const std::vector<fs::path> runs = FindRuns(folder);
    if (runs.empty()) {
      throw CallError(fmt::format(
          "{}: there are no runs in this folder; name the folder of a study, or of many runs",
          folder.string()));
    }
    return ReadStudyResults(folder, runs);
  }

  // Whether this call is about the experiment: the one that is chosen, or that a statement is
  // about.
  bool IsMeant(const ExperimentResult& experiment) const {
    if (!options_.experiment.empty()) return experiment.experiment->name == options_.experiment;
    return stated_ == nullptr || stated_ == &experiment;
  }

  const TaskParams& ParamsOf(const ExperimentResult& experiment) {
    const TaskRecord& task = experiment.experiment->task();
    const auto found = params_.find(task.task_hash);
    if (found != params_.end()) return found->second;
    return params_.emplace(task.task_hash, ReadTaskParams(task)).first->second;
  }

  // An experiment without weights that can be fitted is passed over.
  void AskAll() {
    for (const ExperimentResult& experiment : study_.experiments) {
      if (!IsMeant(experiment) || experiment.groups.size() < 2) continue;
      try {
        if (!AskPreferences(study_, experiment, ParamsOf(experiment), options_.folder)) break;
      } catch (const UserError& error) {
        text::Print("\n{}\n", error.what());
      }
    }
    text::Print("\n");
  }

  std::vector<PreferenceFit> FitAll() {
    const std::vector<std::vector<Preference>> preferences = PreferencesByExperiment(
        study_.experiments, ReadPreferences(options_.folder), options_.folder);
    std::vector<PreferenceFit> fits;
    for (size_t i = 0; i < preferences.size(); ++i) {
      const ExperimentResult& experiment = study_.experiments[i];
      if (preferences[i].empty() || !IsMeant(experiment)) continue;
      fits.push_back(
          FitPreferences(experiment, ParamsOf(experiment), preferences[i], options_.factor));
    }
    if (!fits.empty()) return fits;
    throw UserError(
        fmt::format("{}: no preferences are stated yet; watch the runs (`trainer report {}`), then "
                    "say which is better: `trainer prefer {} --better seed3 --worse seed1`",
                    options_.folder.string(), options_.folder.string(), options_.folder.string()));
  }

  std::vector<fs::path> WriteTask(const std::vector<PreferenceFit>& fits) const {
    if (options_.output.empty()) return {};
    if (fits.size() > 1) {
      throw CallError(
          "-o writes one task, but there are preferences in several experiments; choose one with "
          "--experiment NAME");
    }
    const std::vector<fs::path> written = WriteWeights(
        fits.front(), study_.name, {options_.output, options_.task, options_.is_forced});
    if (!options_.json) {
      text::Print("wrote {}\n\nNext:\n  {}\n", written.front().string(),
                  NextCommand(*fits.front().result, options_.output));
    }
    return written;
  }

  void Print(const std::vector<PreferenceFit>& fits) const {
    for (const PreferenceFit& fit : fits) {
      text::Print("{}\n", PreferenceText(fit));
      const bool has_news = std::ranges::any_of(fit.weights, [](const WeightChange& weight) {
        return weight.value.after != weight.value.before;
      });
      if (!has_news || !options_.output.empty()) continue;
      text::Print(
          "To train with the new weights, write them as a task:\n  trainer prefer {} "
          "--experiment {} -o {}_preferred.task\n\n",
          options_.folder.string(), fit.result->experiment->name,
          fit.result->experiment->task().task);
    }
  }

  void PrintJson(const std::vector<PreferenceFit>& fits, const std::vector<fs::path>& written) {
    nlohmann::ordered_json experiments = nlohmann::ordered_json::array();
    for (const PreferenceFit& fit : fits) experiments.push_back(PreferenceFigures(fit));
    nlohmann::ordered_json files = nlohmann::ordered_json::array();
    for (const fs::path& file : written) files.push_back(file.string());
    const nlohmann::ordered_json json = {{"folder", study_.name},
                                         {"factor", options_.factor},
                                         {"experiments", std::move(experiments)},
                                         {"written", std::move(files)}};
    text::Print("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  }

  const PreferOptions& options_;
  const StudyResults study_;
  const ExperimentResult* stated_ = nullptr;  // about which this call makes a statement
  std::map<std::string, TaskParams> params_;  // by the tasks' hashes
};

}  // namespace

void AddPreferCommand(command_line::Command& program) {
  const auto options = std::make_shared<PreferOptions>();
  command_line::Command& command =
      program.AddCommand("prefer",
                         "Fits the weights of a task to your preferences, shows what would change, "
                         "and writes a new task.");
  command.AddOption("DIR", options->folder, "folder of the runs").Required();
  options->statements.AddTo(command);
  command.AddOption("--experiment", options->experiment, "only this experiment");
  command
      .AddOption(
          "--factor", options->factor,
          "factor by which a weight is expected to change at most, in two cases out of three")
      .Range(1.01, 1000.)
      .ShowDefault();
  const command_line::Option output =
      command
          .AddOption("-o,--output", options->output, "write the new weights as a task: FILE.task")
          .ValueName("FILE");
  command
      .AddOption("--task", options->task,
                 "task file that the new one extends; by default that of the runs")
      .ValueName("FILE")
      .Needs(output);
  command.AddFlag("--force", options->is_forced, "overwrite an existing task").Needs(output);
  command.AddFlag("--json", options->json, "print JSON, and ask nothing");
  command.Notes(
      "Preferences are kept in DIR/preferences.toml. Without a new one, and without -o, it asks on "
      "a terminal\nwhich of two groups of behaviors is better.");
  command.OnRun([options] {
    PreferCommand(*options).Run();
    return kSuccess;
  });
}

}  // namespace runtime
