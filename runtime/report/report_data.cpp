#include "runtime/report/report_data.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "runtime/module/user_error.h"
#include "runtime/report/agent_modules.h"
#include "runtime/report/base64.h"
#include "runtime/report/report_recordings.h"
#include "runtime/run/run_database.h"

namespace runtime {
namespace {

using nlohmann::json;

// What the run notes of itself and the page shows as it is.
constexpr const char* kRunKeys[] = {
    "task",    "task_file", "task_hash",  "robot",       "profile", "seed", "episodes_planned",
    "version", "compiler",  "started_at", "finished_at",
};

template <class Value>
std::string EncodeSeries(const std::vector<EpisodeRecord>& episodes, Value value) {
  std::vector<float> values;
  values.reserve(episodes.size());
  for (const EpisodeRecord& episode : episodes)
    values.push_back(static_cast<float>(value(episode)));
  return EncodeFloats(values);
}

// The series `member`[`index`]; an episode that lacks it has a NaN there.
std::string EncodeElement(const std::vector<EpisodeRecord>& episodes,
                          std::vector<double> EpisodeRecord::*member, size_t index) {
  return EncodeSeries(episodes, [&](const EpisodeRecord& episode) {
    const std::vector<double>& values = episode.*member;
    return index < values.size() ? values[index] : std::numeric_limits<double>::quiet_NaN();
  });
}

json RunTexts(const RunDatabase& database) {
  json texts = json::object();
  for (const char* key : kRunKeys) texts[key] = database.ReadValue(key);
  texts["state"] = RunStateName(database.ReadState());
  return texts;
}

json Terms(const RunRecord& run, const std::vector<EpisodeRecord>& episodes) {
  json terms = json::array();
  for (const TermRecord& term : run.terms) {
    terms.push_back({{"name", term.name},
                     {"unit", ""},
                     {"reduction", ""},
                     {"doc", term.doc},
                     {"values", EncodeElement(episodes, &EpisodeRecord::terms, terms.size())}});
  }
  return terms;
}

json Sources(const RunRecord& run) {
  json sources = json::array();
  for (const SourceRecord& source : run.sources) {
    sources.push_back({{"file", source.file}, {"text", source.text}});
  }
  return sources;
}

// Metrics or logs.
json Curves(const std::vector<CurveRecord>& records, const std::vector<EpisodeRecord>& episodes,
            std::vector<double> EpisodeRecord::*member) {
  json curves = json::array();
  for (const CurveRecord& record : records) {
    curves.push_back({{"name", record.name},
                      {"unit", record.unit},
                      {"reduction", record.reduction},
                      {"doc", record.doc},
                      {"values", EncodeElement(episodes, member, curves.size())}});
  }
  return curves;
}

// The different ends with their counts, in the order of their first episodes, and for each episode
// which of them it had.
void AddEnds(const std::vector<EpisodeRecord>& episodes, json& data) {
  json ends = json::array();
  json end_of = json::array();
  std::map<std::pair<std::string, std::string>, size_t> index;
  for (const EpisodeRecord& episode : episodes) {
    const auto [found, is_new] =
        index.try_emplace({episode.end_kind, episode.end_reason}, ends.size());
    if (is_new) {
      ends.push_back({{"kind", episode.end_kind}, {"reason", episode.end_reason}, {"count", 0}});
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
    faults += episode.faults;
    violations += episode.violations;
  }
  data["simulatedSeconds"] = simulated;
  data["wallSeconds"] = wall;
  data["faults"] = faults;
  data["violations"] = violations;
}

}  // namespace

json CollectReportData(const std::filesystem::path& run_dir) {
  const RunDatabase database = RunDatabase::OpenToRead(run_dir);
  const RunRecord run = database.ReadRun();
  const std::vector<EpisodeRecord> episodes = database.ReadEpisodes();
  if (episodes.empty()) {
    throw UserError(fmt::format(
        "{}: the run has no finished episode yet; wait for the first one, then ask for the report",
        run_dir.string()));
  }
  json data;
  data["run"] = RunTexts(database);
  data["sources"] = Sources(run);
  data["agentText"] = run.agent;
  data["modules"] = AgentModules(run.agent);
  data["madeAt"] =
      fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                  std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now()));
  data["episode"] = EncodeSeries(episodes, [](const EpisodeRecord& e) { return e.number; });
  data["returns"] = EncodeSeries(episodes, [](const EpisodeRecord& e) { return e.episode_return; });
  data["terms"] = Terms(run, episodes);
  data["metrics"] = Curves(run.metrics, episodes, &EpisodeRecord::metrics);
  data["logs"] = Curves(run.logs, episodes, &EpisodeRecord::logs);
  AddEnds(episodes, data);
  AddTotals(episodes, data);
  AddRecordings(run_dir, database, run.body, episodes, data);
  return data;
}

}  // namespace runtime
