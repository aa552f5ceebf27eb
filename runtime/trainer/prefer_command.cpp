#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "runtime/study/compared_behavior.h"
#include "runtime/study/preference_figures.h"
#include "runtime/trainer/call_error.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/many_runs.h"
#include "runtime/trainer/prefer_dialog.h"
#include "runtime/trainer/prefer_text.h"
#include "runtime/trainer/write_gains.h"

namespace runtime {
namespace {

namespace fs = std::filesystem;

struct PreferOptions {
  fs::path folder;
  std::string better;
  std::string worse;
  std::vector<std::string> order;
  std::vector<std::string> equal;
  std::string experiment;
  double factor = kExpectedFactor;
  fs::path output;
  fs::path task;
  bool is_forced = false;
  bool json = false;

  bool has_statement() const { return !better.empty() || !order.empty() || !equal.empty(); }
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
    throw CallError(fmt::format("--experiment {}: there is none in {}; there are {}",
                                options_.experiment, options_.folder.string(),
                                fmt::join(names, ", ")));
  }

  void Run() {
    NoteStatements();
    const bool may_ask = !options_.has_statement() && options_.output.empty() && !options_.json;
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
      throw CallError(
          fmt::format("{}: there are no runs in this folder; give that of a study, or of "
                      "many runs",
                      folder.string()));
    }
    return ReadStudyResults(folder, runs);
  }

  // What the command line says. A behavior that cannot be compared is an error at once.
  void NoteStatements() {
    std::vector<Preference> preferences;
    const auto add = [&](const std::vector<std::string>& names, bool is_tie) {
      const std::vector<BehaviorName> behaviors =
          FindBehaviors(study_.experiments, names, options_.experiment);
      for (size_t i = 0; i + 1 < behaviors.size(); ++i) {
        preferences.push_back({behaviors[i], behaviors[i + 1], is_tie});
      }
    };
    if (!options_.better.empty()) add({options_.better, options_.worse}, false);
    if (!options_.order.empty()) add(options_.order, false);
    if (!options_.equal.empty()) add(options_.equal, true);
    if (preferences.empty()) return;
    for (const Preference& preference : preferences) Check(preference);
    AddPreferences(options_.folder, preferences);
  }

  void Check(const Preference& preference) {
    if (preference.better == preference.worse) {
      throw CallError(fmt::format("{} is compared with itself", preference.better.text()));
    }
    const ExperimentResult& experiment = ExperimentOf(preference.better.run);
    if (&experiment != &ExperimentOf(preference.worse.run)) {
      throw CallError(fmt::format("{} and {} are runs of two experiments; compare runs of one",
                                  preference.better.run, preference.worse.run));
    }
    for (const BehaviorName* behavior : {&preference.better, &preference.worse}) {
      const RunResult& run = experiment.runs[FindRun(experiment, behavior->run).value()];
      if (const auto why = WhyIncomparable(*run.run)) {
        throw UserError(fmt::format("{} cannot be compared: {}", behavior->run, *why));
      }
      TermSums(run, *behavior);
    }
    stated_ = &experiment;
  }

  const ExperimentResult& ExperimentOf(const std::string& run) const {
    return *std::ranges::find_if(study_.experiments, [&](const ExperimentResult& each) {
      return FindRun(each, run).has_value();
    });
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

  // An experiment without gains that can be fitted is passed over.
  void AskAll() {
    for (const ExperimentResult& experiment : study_.experiments) {
      if (!IsMeant(experiment) || experiment.groups.size() < 2) continue;
      try {
        if (!AskPreferences(study_, experiment, ParamsOf(experiment), options_.folder)) break;
      } catch (const UserError& error) {
        fmt::print("\n{}\n", error.what());
      }
    }
    fmt::print("\n");
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
    throw UserError(fmt::format(
        "{}: no preferences are stated yet; watch the runs (`trainer report {}`), then say what is "
        "better: `trainer prefer {} --better seed3 --worse seed1`",
        options_.folder.string(), options_.folder.string(), options_.folder.string()));
  }

  std::vector<fs::path> WriteTask(const std::vector<PreferenceFit>& fits) const {
    if (options_.output.empty()) return {};
    if (fits.size() > 1) {
      throw CallError(
          "-o writes one task, and there are preferences in several experiments; say in which: "
          "--experiment NAME");
    }
    const std::vector<fs::path> written =
        WriteGains(fits.front(), study_.name, {options_.output, options_.task, options_.is_forced});
    if (!options_.json) {
      fmt::print("wrote {}\n\nNext:\n  {}\n", written.front().string(),
                 NextCommand(*fits.front().result, options_.output));
    }
    return written;
  }

  void Print(const std::vector<PreferenceFit>& fits) const {
    for (const PreferenceFit& fit : fits) {
      fmt::print("{}\n", PreferenceText(fit));
      const bool has_news = std::ranges::any_of(
          fit.gains, [](const GainChange& gain) { return gain.value.after != gain.value.before; });
      if (!has_news || !options_.output.empty()) continue;
      fmt::print(
          "To train with the new gains, write them as a task:\n  trainer prefer {} "
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
    fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  }

  const PreferOptions& options_;
  const StudyResults study_;
  const ExperimentResult* stated_ = nullptr;  // about which this call makes a statement
  std::map<std::string, TaskParams> params_;  // by the tasks' hashes
};

void AddStatementOptions(CLI::App& command, PreferOptions& options) {
  const std::string name = "a run, or RUN:EPISODE; its name may be shortened: `seed3`";
  CLI::Option* better = command.add_option("--better", options.better, name);
  CLI::Option* worse = command.add_option("--worse", options.worse, "than which it is better");
  better->needs(worse);
  worse->needs(better);
  command.add_option("--order", options.order, "runs, or RUN:EPISODE, the best first")
      ->expected(2, CLI::detail::expected_max_vector_size);
  command.add_option("--equal", options.equal, "two that are equally good")->expected(2);
}

}  // namespace

void AddPreferCommand(CLI::App& app, int& status) {
  const auto options = std::make_shared<PreferOptions>();
  CLI::App* command = app.add_subcommand(
      "prefer",
      "Fits the gains of a task to what you call better, shows what would change, and writes it.");
  command->add_option("DIR", options->folder, "folder of the runs")->required();
  AddStatementOptions(*command, *options);
  command->add_option("--experiment", options->experiment, "look at this one only");
  command
      ->add_option("--factor", options->factor,
                   "by which a gain is expected to change at most, in two cases out of three")
      ->check(CLI::Range(1.01, 1000.))
      ->capture_default_str();
  CLI::Option* output = command->add_option("-o,--output", options->output,
                                            "write the new gains as a task: FILE.task");
  command->add_option("--task", options->task, "which it extends; otherwise that of the runs")
      ->needs(output);
  command->add_flag("--force", options->is_forced, "write over a task that is there")
      ->needs(output);
  command->add_flag("--json", options->json, "print JSON, and ask nothing");
  command->footer(
      "What is stated is kept in DIR/preferences.toml. Without a statement, and without -o, it "
      "asks "
      "on a\nterminal which of two groups of behaviors is better.");
  command->callback([options, &status] {
    PreferCommand(*options).Run();
    status = kSuccess;
  });
}

}  // namespace runtime
