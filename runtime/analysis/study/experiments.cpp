#include "runtime/analysis/study/experiments.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "runtime/base/in_parallel.h"
#include "runtime/base/user_error.h"
#include "runtime/training/run/run_settings.h"

namespace runtime {
namespace {

// What the runs of an experiment have in common.
using Key = std::vector<std::string>;

Key KeyOf(const StudyRun& run) {
  return {run.folder.parent_path().string(), run.record.tasks.front().task_hash,
          run.record.robot_description, run.record.profile, run.record.agent};
}

// Of a run that has learned on since, an evaluation says nothing of what came out.
void TakeEvaluations(StudyRun& run, std::vector<std::string>& notes) {
  for (PolicyEvaluation& evaluation : ReadEvaluations(run.folder, notes)) {
    if (!run.is_finished() || evaluation.checkpoint_episode == run.episodes.back().number) {
      run.evaluations.push_back(std::move(evaluation));
    } else {
      notes.push_back(
          fmt::format("{} has continued to learn since it was evaluated in {}; `trainer evaluate` "
                      "evaluates it again.",
                      run.name, evaluation.profile));
    }
  }
}

std::optional<StudyRun> ReadRun(const std::filesystem::path& study,
                                const std::filesystem::path& folder,
                                std::vector<std::string>& notes) {
  StudyRun run{folder, folder.lexically_relative(study).string(), {}, {}, {}, 0, {}};
  try {
    const RunDatabase database = RunDatabase::OpenToRead(folder);
    RunAndEpisodes read = database.ReadRunAndEpisodes();
    run.record = std::move(read.run);
    run.episodes = std::move(read.episodes);
    run.state = database.ReadState();
    run.changes = database.ReadChanges().size();
  } catch (const UserError& error) {
    notes.push_back(fmt::format("{} is left out: {}", run.name, error.what()));
    return std::nullopt;
  }
  TakeEvaluations(run, notes);
  if (run.changes > 0) {
    notes.push_back(fmt::format("{} was changed while it learned, {}; its own report says how.",
                                run.name,
                                run.changes == 1 ? "once" : fmt::format("{} times", run.changes)));
  }
  return run;
}

std::string NameOf(const StudyExperiment& experiment, const std::filesystem::path& study,
                   std::set<std::string>& taken) {
  const std::filesystem::path parent = experiment.runs.front().folder.parent_path();
  const std::string folder = parent.lexically_relative(study).string();
  const bool has_folder = !folder.empty() && folder[0] != '.';  // else "." or ".."
  const std::string stem = has_folder ? folder : NameOfRuns(experiment.record());
  std::string name = stem;
  for (int count = 2; !taken.insert(name).second; ++count) {
    name = fmt::format("{} ({})", stem, count);
  }
  return name;
}

}  // namespace

bool StudyRun::is_finished() const {
  return static_cast<int64_t>(episodes.size()) >= record.episodes_planned;
}

Study ReadStudyRuns(const std::filesystem::path& folder,
                    const std::vector<std::filesystem::path>& runs) {
  std::vector<std::optional<StudyRun>> read(runs.size());
  std::vector<std::vector<std::string>> notes(runs.size());
  InParallel(runs.size(), [&](size_t i) { read[i] = ReadRun(folder, runs[i], notes[i]); });
  Study study;
  std::map<Key, size_t> index;
  for (size_t i = 0; i < runs.size(); ++i) {
    std::ranges::move(notes[i], std::back_inserter(study.notes));
    std::optional<StudyRun>& run = read[i];
    if (!run) continue;
    const auto [place, is_new] = index.try_emplace(KeyOf(*run), study.experiments.size());
    if (is_new) study.experiments.emplace_back();
    study.experiments[place->second].runs.push_back(std::move(*run));
  }
  std::set<std::string> taken;
  for (StudyExperiment& experiment : study.experiments) {
    experiment.name = NameOf(experiment, folder, taken);
  }
  return study;
}

}  // namespace runtime
