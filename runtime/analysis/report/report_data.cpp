#include "runtime/analysis/report/report_data.h"

#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "runtime/analysis/curves/goal_curves.h"
#include "runtime/analysis/curves/learner_curves.h"
#include "runtime/analysis/curves/task_curves.h"
#include "runtime/analysis/report/agent_modules.h"
#include "runtime/analysis/report/base64.h"
#include "runtime/analysis/report/encoded_curves.h"
#include "runtime/analysis/report/page.h"
#include "runtime/analysis/report/report_changes.h"
#include "runtime/analysis/report/report_recordings.h"
#include "runtime/base/user_error.h"
#include "runtime/training/run/estimate.h"
#include "runtime/training/run/iso_time.h"
#include "runtime/training/run/policy_evaluation.h"
#include "runtime/training/run/recorded_ground.h"
#include "runtime/training/run/run_database.h"
#include "runtime/training/run/run_settings.h"

namespace runtime {
namespace {

using nlohmann::json;

// What the run notes of itself and the page shows as it is.
constexpr const char* kRunKeys[] = {
    "robot", "profile", "seed", "episodes_planned", "version", "started_at", "finished_at",
};

template <class Value>
std::string EncodeSeries(const std::vector<EpisodeRecord>& episodes, Value value) {
  std::vector<float> values;
  values.reserve(episodes.size());
  for (const EpisodeRecord& episode : episodes)
    values.push_back(static_cast<float>(value(episode)));
  return EncodeFloats(values);
}

// The task is the one that was active last.
json RunTexts(const RunDatabase& database, const TaskRecord& task) {
  json texts = {{"task", task.task},
                {"task_file", task.task_file},
                {"task_hash", task.task_hash},
                {"compiler", task.compiler}};
  for (const char* key : kRunKeys) texts[key] = database.ReadValue(key);
  texts["state"] = RunStateName(database.ReadState());
  return texts;
}

// The different ends with their counts, in the order of their first episodes, and for each episode
// which of them it had.
void AddEnds(const std::vector<EpisodeRecord>& episodes, json& data) {
  json ends = json::array();
  json end_of = json::array();
  std::map<std::pair<std::string, std::string>, size_t> index;
  for (const EpisodeRecord& episode : episodes) {
    const auto [found, is_new] =
        index.try_emplace({episode.active.end_kind, episode.active.end_reason}, ends.size());
    if (is_new) {
      ends.push_back({{"kind", found->first.first}, {"reason", found->first.second}, {"count", 0}});
    }
    json& count = ends[found->second]["count"];
    count = count.get<int64_t>() + 1;
    end_of.push_back(found->second);
  }
  data["ends"] = std::move(ends);
  data["endOf"] = std::move(end_of);
}

void AddTotals(const std::vector<EpisodeRecord>& episodes, json& data) {
  double simulated = 0;
  double wall = 0;
  int64_t faults = 0;
  int64_t violations = 0;
  for (const EpisodeRecord& episode : episodes) {
    simulated += episode.simulated_seconds;
    wall += episode.wall_seconds;
    faults += episode.active.faults;
    violations += episode.active.violations;
  }
  data["simulatedSeconds"] = simulated;
  data["wallSeconds"] = wall;
  data["faults"] = faults;
  data["violations"] = violations;
}

// What cannot be read is left out with a note.
void AddEvaluations(const std::filesystem::path& run_dir, json& data) {
  std::vector<std::string> notes;
  json& evaluations = data["evaluations"] = json::array();
  for (const PolicyEvaluation& evaluation : ReadEvaluations(run_dir, notes)) {
    evaluations.push_back({{"profile", evaluation.profile},
                           {"checkpoint_episode", evaluation.checkpoint_episode},
                           {"return", ToJson(EstimateMean(evaluation.returns))},
                           {"learned_return", evaluation.learned_return},
                           {"share", evaluation.share()},
                           {"ends", evaluation.ends}});
  }
  for (std::string& note : notes) data["notes"].push_back(std::move(note));
}

// All but recordings and evaluations.
json CollectCurves(const RunDatabase& database, const RunRecord& run,
                   const std::vector<EpisodeRecord>& episodes) {
  json data;
  const TaskRecord& task =
      episodes.empty() ? run.tasks.front() : TaskWithId(run, episodes.back().active.task);
  data["title"] = task.task + " – learning run";
  data["run"] = RunTexts(database, task);
  data["settings"] = SettingsJson(run);
  data["command"] = TrainCommand(run);
  data["agentText"] = run.agent;
  data["modules"] = AgentModules(run.agent);
  data["madeAt"] = IsoTimeNow();
  data["episode"] = EncodeSeries(episodes, [](const EpisodeRecord& e) { return e.number; });
  data["returns"] =
      EncodeSeries(episodes, [](const EpisodeRecord& e) { return e.active.episode_return; });
  data["terms"] = EncodeCurves(TermCurves(run, episodes));
  data["metrics"] = EncodeCurves(MetricCurves(run, episodes));
  data["logs"] = EncodeCurves(LogCurves(run, episodes));
  data["goals"] = EncodeCurves(GoalCurves(run, episodes));
  data["phases"] = EncodeCurves(PhaseCurves(run, episodes));
  data["learner"] = EncodeCurves(LearnerCurves(database.ReadLearnerCurves(), episodes));
  AddEnds(episodes, data);
  AddTotals(episodes, data);
  AddChanges(run, episodes, database.ReadChanges(), data);
  return data;
}

}  // namespace

json CollectReportData(const std::filesystem::path& run_dir) {
  const RunDatabase database = RunDatabase::OpenToRead(run_dir);
  const auto [run, episodes] = database.ReadRunAndEpisodes();
  if (episodes.empty()) {
    throw UserError(fmt::format(
        "{}: the run has no finished episode yet; wait for the first one, then ask for the report",
        run_dir.string()));
  }
  json data = CollectCurves(database, run, episodes);
  AddRecordings(database, run, episodes, data);
  AddEvaluations(run_dir, data);
  return data;
}

json CollectRecord(const std::filesystem::path& run_dir) {
  const RunDatabase database = RunDatabase::OpenToRead(run_dir);
  const auto [run, episodes] = database.ReadRunAndEpisodes();
  json data = CollectCurves(database, run, episodes);
  data["body"] = json::parse(run.body);
  data["ground"] = GroundJson(GroundOf(run));
  for (const char* none : {"recordings", "evaluations", "notes"}) data[none] = json::array();
  return data;
}

}  // namespace runtime
