#include "runtime/analysis/study/stated_preferences.h"

#include <fmt/format.h>

#include "runtime/analysis/study/preference_figures.h"
#include "runtime/base/user_error.h"

namespace runtime {

std::vector<nlohmann::ordered_json> StatedPreferences(const StudyResults& study,
                                                      const std::filesystem::path& folder,
                                                      std::vector<std::string>& notes) {
  std::vector<nlohmann::ordered_json> figures(study.experiments.size());
  const std::vector<Preference> stated = ReadPreferences(folder);
  if (stated.empty()) return figures;
  try {
    const auto sorted = PreferencesByExperiment(study.experiments, stated, folder);
    for (size_t i = 0; i < sorted.size(); ++i) {
      const ExperimentResult& experiment = study.experiments[i];
      if (sorted[i].empty()) continue;
      const TaskParams params = ReadTaskParams(experiment.experiment->task());
      figures[i] = PreferenceFigures(FitPreferences(experiment, params, sorted[i]));
    }
  } catch (const UserError& error) {
    notes.push_back(fmt::format("The preferences are left out: {}.", error.what()));
  }
  return figures;
}

}  // namespace runtime
