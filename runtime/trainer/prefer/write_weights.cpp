#include "runtime/trainer/prefer/write_weights.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/analysis/preference/preferred_task.h"
#include "runtime/analysis/preference/weight_value.h"
#include "runtime/base/user_error.h"

namespace runtime {
namespace {

namespace fs = std::filesystem;

// The file of the task, which must be what it was when the runs were trained.
fs::path BaseOf(const TaskRecord& task, const fs::path& wanted) {
  constexpr const char* kRemedy = "name a file that holds this version: --task FILE";
  const fs::path file = wanted.empty() ? fs::path(task.task_file) : wanted;
  if (!fs::exists(file)) {
    throw UserError(fmt::format("{}: this file, from which {} was built, no longer exists; {}",
                                file.string(), VersionText(task), kRemedy));
  }
  const std::string hash = ReadTaskParams(file).task_hash;
  if (hash != task.task_hash) {
    throw UserError(fmt::format("{} has changed: it is {:.8} now, and the runs learned {}; {}",
                                file.string(), hash, VersionText(task), kRemedy));
  }
  return file;
}

std::string KeptText(const KeptParam& kept) {
  if (kept.recorded.kind != RecordedParam::Kind::kCondition) {
    return ValueText(kept.recorded.value, kept.param.unit);
  }
  return kept.recorded.value != 0 ? "true" : "false";
}

// All params that are not what the base says.
std::vector<ParamOverride> OverridesOf(const PreferenceFit& fit) {
  std::vector<ParamOverride> overrides;
  for (const WeightChange& weight : fit.weights) {
    if (weight.value.after == weight.param.initial) continue;
    overrides.push_back({weight.param.name, ValueText(weight.value.after, weight.param.unit),
                         "was " + ValueText(weight.value.before, weight.param.unit)});
  }
  for (const KeptParam& kept : fit.kept) {
    if (kept.recorded.value == kept.param.initial) continue;
    overrides.push_back({kept.param.name, KeptText(kept), "as in these runs"});
  }
  return overrides;
}

}  // namespace

std::vector<fs::path> WriteWeights(const PreferenceFit& fit, const std::string& study,
                                   const WeightsFile& target) {
  const StudyExperiment& experiment = *fit.result->experiment;
  const size_t count = fit.preferences.size();
  return WritePreferredTask(
      {target.file, BaseOf(experiment.task(), target.base),
       fmt::format("{} with weights fitted to {} preference{} in {} of {}.", experiment.task().task,
                   count, count == 1 ? "" : "s", experiment.name, study),
       OverridesOf(fit)},
      target.is_forced);
}

std::string NextCommand(const ExperimentResult& experiment, const fs::path& task) {
  const RunRecord& record = experiment.experiment->record();
  const size_t runs = experiment.runs.size();
  uint64_t seed = record.seed;
  for (const RunResult& run : experiment.runs) seed = std::min(seed, run.run->record.seed);
  return fmt::format("trainer train {}{} --episodes {} --seed {}{} --out {}", task.string(),
                     record.profile.empty() ? "" : " --profile " + record.profile,
                     record.episodes_planned, seed, runs > 1 ? fmt::format(" --runs {}", runs) : "",
                     (fs::path("runs") / task.stem()).string());
}

}  // namespace runtime
