#include "runtime/analysis/export/episode_table.h"

#include <fmt/format.h>

#include <functional>
#include <utility>

#include "runtime/analysis/curves/goal_curves.h"
#include "runtime/analysis/curves/learner_curves.h"
#include "runtime/analysis/curves/task_curves.h"
#include "runtime/training/run/iso_time.h"

namespace runtime {
namespace {

using Number = std::function<double(const EpisodeRecord&)>;

std::vector<EpisodeColumn> OwnColumns(const std::vector<EpisodeRecord>& episodes) {
  const std::pair<const char*, Number> numbers[] = {
      {"return", [](const EpisodeRecord& e) { return e.active.episode_return; }},
      {"steps", [](const EpisodeRecord& e) { return static_cast<double>(e.steps); }},
      {"actions", [](const EpisodeRecord& e) { return static_cast<double>(e.actions); }},
      {"simulated [s]", [](const EpisodeRecord& e) { return e.simulated_seconds; }},
      {"wall [s]", [](const EpisodeRecord& e) { return e.wall_seconds; }},
      {"cpu [s]", [](const EpisodeRecord& e) { return e.cpu_seconds; }},
      {"faults", [](const EpisodeRecord& e) { return static_cast<double>(e.active.faults); }},
      {"violations",
       [](const EpisodeRecord& e) { return static_cast<double>(e.active.violations); }},
  };
  std::vector<EpisodeColumn> columns;
  for (const auto& [name, number] : numbers) {
    EpisodeColumn& column = columns.emplace_back(name);
    for (const EpisodeRecord& episode : episodes) column.values.push_back(number(episode));
  }
  return columns;
}

void AddCurves(const char* kind, std::vector<Curve> curves, std::vector<EpisodeColumn>& columns) {
  for (Curve& curve : curves) {
    const std::string& unit = curve.record.unit;
    columns.push_back({fmt::format("{}/{}{}", kind, curve.record.name,
                                   unit.empty() ? "" : fmt::format(" [{}]", unit)),
                       std::move(curve.values)});
  }
}

std::vector<double> EndTimes(const std::string& started_at,
                             const std::vector<EpisodeRecord>& episodes) {
  std::vector<double> times;
  double time = SecondsSince1970(started_at);
  for (const EpisodeRecord& episode : episodes) times.push_back(time += episode.wall_seconds);
  return times;
}

}  // namespace

EpisodeTable ReadEpisodeTable(const RunDatabase& database) {
  auto [run, episodes] = database.ReadRunAndEpisodes();
  EpisodeTable table;
  table.episodes = std::move(episodes);
  table.columns = OwnColumns(table.episodes);
  AddCurves("term", TermCurves(run, table.episodes), table.columns);
  AddCurves("metric", MetricCurves(run, table.episodes), table.columns);
  AddCurves("log", LogCurves(run, table.episodes), table.columns);
  AddCurves("goal", GoalCurves(run, table.episodes), table.columns);
  AddCurves("phase", PhaseCurves(run, table.episodes), table.columns);
  AddCurves("learner", LearnerCurves(database.ReadLearnerCurves(), table.episodes), table.columns);
  table.end_times = EndTimes(database.ReadValue("started_at"), table.episodes);
  return table;
}

}  // namespace runtime
