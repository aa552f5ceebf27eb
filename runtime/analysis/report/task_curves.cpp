#include "runtime/analysis/report/task_curves.h"

#include <limits>
#include <map>

#include "runtime/analysis/report/base64.h"

namespace runtime {
namespace {

using nlohmann::json;
using Records = std::function<std::vector<CurveRecord>(const TaskRecord&)>;

struct Curve {
  CurveRecord record;
  std::vector<int64_t> tasks;  // indices of those that have it
  std::vector<float> values;   // one for each episode
};

std::vector<CurveRecord> Terms(const TaskRecord& task) {
  std::vector<CurveRecord> records;
  for (const TermRecord& term : task.terms) records.push_back({term.name, "", "", term.doc});
  return records;
}

std::vector<CurveRecord> Phases(const TaskRecord& task) {
  std::vector<CurveRecord> records;
  for (const PhaseRecord& phase : task.phases) {
    records.push_back({phase.name + ": time", "s", "sum", phase.doc});
    records.push_back({phase.name + ": return", "", "sum", phase.doc});
  }
  return records;
}

std::vector<CurveRecord> Metrics(const TaskRecord& task) { return task.metrics; }
std::vector<CurveRecord> Logs(const TaskRecord& task) { return task.logs; }

class Curves {
 public:
  Curves(const RunRecord& run, size_t episode_count, const Records& records)
      : run_(run), episode_count_(episode_count), records_(records) {}

  // What the task with this id said of the episode with this index.
  void Add(size_t episode, int64_t task, const std::vector<double>& values) {
    const auto [place, is_new] = curves_of_.try_emplace(task);
    if (is_new) place->second = FindAll(TaskWithId(run_, task));
    for (size_t i = 0; i < values.size(); ++i) {
      curves_[place->second[i]].values[episode] = static_cast<float>(values[i]);
    }
  }

  json Encode() const {
    json curves = json::array();
    for (const auto& [record, tasks, values] : curves_) {
      curves.push_back({{"name", record.name},
                        {"unit", record.unit},
                        {"reduction", record.reduction},
                        {"doc", record.doc},
                        {"tasks", tasks},
                        {"values", EncodeFloats(values)}});
    }
    return curves;
  }

 private:
  std::vector<size_t> FindAll(const TaskRecord& task) {
    std::vector<size_t> indices;
    for (const CurveRecord& record : records_(task)) {
      indices.push_back(Find(record));
      curves_[indices.back()].tasks.push_back(task.id - 1);
    }
    return indices;
  }

  size_t Find(const CurveRecord& record) {
    const auto [place, is_new] = index_.try_emplace({record.name, record.unit}, curves_.size());
    if (is_new) {
      constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
      curves_.push_back({record, {}, std::vector<float>(episode_count_, kNothing)});
    }
    return place->second;
  }

  const RunRecord& run_;
  const size_t episode_count_;
  const Records& records_;
  std::vector<Curve> curves_;
  std::map<std::pair<std::string, std::string>, size_t> index_;  // by name and unit
  std::map<int64_t, std::vector<size_t>> curves_of_;             // by the id of the task
};

json CurvesOf(const RunRecord& run, const std::vector<EpisodeRecord>& episodes,
              const Records& records, std::vector<double> Evaluation::*values) {
  return TaskCurves(run, episodes, records,
                    [&](const EpisodeRecord& episode) { return episode.active.*values; });
}

}  // namespace

json TaskCurves(const RunRecord& run, const std::vector<EpisodeRecord>& episodes,
                const Records& curves,
                const std::function<std::vector<double>(const EpisodeRecord&)>& values) {
  Curves all(run, episodes.size(), curves);
  for (size_t i = 0; i < episodes.size(); ++i) {
    all.Add(i, episodes[i].active.task, values(episodes[i]));
  }
  return all.Encode();
}

json TermCurves(const RunRecord& run, const std::vector<EpisodeRecord>& episodes) {
  return CurvesOf(run, episodes, Terms, &Evaluation::terms);
}

json MetricCurves(const RunRecord& run, const std::vector<EpisodeRecord>& episodes) {
  return CurvesOf(run, episodes, Metrics, &Evaluation::metrics);
}

json LogCurves(const RunRecord& run, const std::vector<EpisodeRecord>& episodes) {
  return CurvesOf(run, episodes, Logs, &Evaluation::logs);
}

json PhaseCurves(const RunRecord& run, const std::vector<EpisodeRecord>& episodes) {
  return TaskCurves(run, episodes, Phases, [](const EpisodeRecord& episode) {
    std::vector<double> values;
    for (const PhaseSums& phase : episode.active.phases) {
      values.push_back(phase.time);
      values.push_back(phase.reward);
    }
    return values;
  });
}

}  // namespace runtime
