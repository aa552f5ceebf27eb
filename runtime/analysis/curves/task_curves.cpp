#include "runtime/analysis/curves/task_curves.h"

#include <limits>
#include <map>
#include <utility>

namespace runtime {
namespace {

using Records = std::function<std::vector<CurveRecord>(const TaskRecord&)>;

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
      curves_[place->second[i]].values[episode] = values[i];
    }
  }

  std::vector<Curve> Take() { return std::move(curves_); }

 private:
  std::vector<size_t> FindAll(const TaskRecord& task) {
    std::vector<size_t> indices;
    for (const CurveRecord& record : records_(task)) {
      indices.push_back(Find(record));
      curves_[indices.back()].tasks.push_back(task.id);
    }
    return indices;
  }

  size_t Find(const CurveRecord& record) {
    const auto [place, is_new] = index_.try_emplace({record.name, record.unit}, curves_.size());
    if (is_new) {
      constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
      curves_.push_back({record, {}, std::vector<double>(episode_count_, kNothing)});
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

std::vector<Curve> CurvesOf(const RunRecord& run, const std::vector<EpisodeRecord>& episodes,
                            const Records& records, std::vector<double> Evaluation::*values) {
  return TaskCurves(run, episodes, records,
                    [&](const EpisodeRecord& episode) { return episode.active.*values; });
}

}  // namespace

std::vector<Curve> TaskCurves(
    const RunRecord& run, const std::vector<EpisodeRecord>& episodes, const Records& curves,
    const std::function<std::vector<double>(const EpisodeRecord&)>& values) {
  Curves all(run, episodes.size(), curves);
  for (size_t i = 0; i < episodes.size(); ++i) {
    all.Add(i, episodes[i].active.task, values(episodes[i]));
  }
  return all.Take();
}

std::vector<Curve> TermCurves(const RunRecord& run, const std::vector<EpisodeRecord>& episodes) {
  return CurvesOf(run, episodes, Terms, &Evaluation::terms);
}

std::vector<Curve> MetricCurves(const RunRecord& run, const std::vector<EpisodeRecord>& episodes) {
  return CurvesOf(run, episodes, Metrics, &Evaluation::metrics);
}

std::vector<Curve> LogCurves(const RunRecord& run, const std::vector<EpisodeRecord>& episodes) {
  return CurvesOf(run, episodes, Logs, &Evaluation::logs);
}

std::vector<Curve> PhaseCurves(const RunRecord& run, const std::vector<EpisodeRecord>& episodes) {
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
