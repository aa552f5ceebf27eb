#include "runtime/trainer/prefer/statements.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/analysis/preference/preferences_file.h"
#include "runtime/analysis/study/compared_behavior.h"
#include "runtime/base/user_error.h"

namespace runtime {
namespace {

using command_line::CallError;

const ExperimentResult& ExperimentOf(const StudyResults& study, const std::string& run) {
  return *std::ranges::find_if(study.experiments, [&](const ExperimentResult& each) {
    return FindRun(each, run).has_value();
  });
}

// The experiment that the preference is about.
const ExperimentResult& Check(const Preference& preference, const StudyResults& study) {
  if (preference.better == preference.worse) {
    throw CallError(fmt::format("{} is compared with itself", preference.better.text()));
  }
  const ExperimentResult& experiment = ExperimentOf(study, preference.better.run);
  if (&experiment != &ExperimentOf(study, preference.worse.run)) {
    throw CallError(fmt::format("{} and {} are runs of different experiments; compare runs of one",
                                preference.better.run, preference.worse.run));
  }
  for (const BehaviorName* behavior : {&preference.better, &preference.worse}) {
    const RunResult& run = experiment.runs[FindRun(experiment, behavior->run).value()];
    if (const auto why = WhyIncomparable(*run.run)) {
      throw UserError(fmt::format("{} cannot be compared: {}", behavior->run, *why));
    }
    TermSums(run, *behavior);  // throws where there is no such episode
  }
  return experiment;
}

}  // namespace

void PreferStatements::AddTo(command_line::Command& command) {
  const std::string name = "a run, or RUN:EPISODE; its name may be shortened: `seed3`";
  command_line::Option better_option = command.AddOption("--better", better, name);
  command_line::Option worse_option =
      command.AddOption("--worse", worse, "the one that it is better than");
  better_option.Needs(worse_option);
  worse_option.Needs(better_option);
  command.AddOption("--order", order, "runs, or RUN:EPISODE, the best first").Count(2, 0);
  command.AddOption("--equal", equal, "two that are equally good").Count(2, 2);
}

const ExperimentResult* NoteStatements(const PreferStatements& statements,
                                       const StudyResults& study, const std::string& experiment,
                                       const std::filesystem::path& folder) {
  std::vector<Preference> preferences;
  const auto add = [&](const std::vector<std::string>& names, bool is_tie) {
    const std::vector<BehaviorName> behaviors = FindBehaviors(study.experiments, names, experiment);
    for (size_t i = 0; i + 1 < behaviors.size(); ++i) {
      preferences.push_back({behaviors[i], behaviors[i + 1], is_tie});
    }
  };
  if (!statements.better.empty()) add({statements.better, statements.worse}, false);
  if (!statements.order.empty()) add(statements.order, false);
  if (!statements.equal.empty()) add(statements.equal, true);
  const ExperimentResult* about = nullptr;
  for (const Preference& preference : preferences) about = &Check(preference, study);
  if (about != nullptr) AddPreferences(folder, preferences);
  return about;
}

}  // namespace runtime
