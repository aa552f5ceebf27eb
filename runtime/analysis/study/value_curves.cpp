#include "runtime/analysis/study/value_curves.h"

#include <algorithm>
#include <functional>

#include "runtime/analysis/study/learning.h"

namespace runtime {
namespace {

// A value of one episode; not a number where its task has none of this name.
using EpisodeValue = std::function<double(const RunRecord& run, const EpisodeRecord& episode)>;

template <class Record, class IsSame>
double Find(const std::vector<Record>& records, const std::vector<double>& values, IsSame is_same) {
  const auto found = std::ranges::find_if(records, is_same);
  const auto index = static_cast<size_t>(found - records.begin());
  return index < values.size() ? values[index] : kNoNumber;
}

std::vector<Estimate> MeansOf(const ExperimentResult& result, const std::vector<double>& episodes,
                              const EpisodeValue& value_of) {
  std::vector<std::vector<double>> averages;
  for (const RunResult& run : result.runs) {
    std::vector<double> values;
    for (const EpisodeRecord& episode : run.run->episodes) {
      values.push_back(value_of(run.run->record, episode));
    }
    averages.push_back(MovingAverage(values, result.window));
  }
  std::vector<Estimate> means;
  for (const double episode : episodes) {
    const auto index = static_cast<size_t>(episode) - 1;
    std::vector<double> values;
    for (const std::vector<double>& run : averages) {
      if (index < run.size()) values.push_back(run[index]);
    }
    means.push_back(EstimateMean(values));
  }
  return means;
}

// The different ones of `table` in all tasks of the runs.
template <class Record, class IsSame>
std::vector<Record> Collect(const ExperimentResult& result, std::vector<Record> TaskRecord::*table,
                            IsSame is_same) {
  std::vector<Record> found;
  for (const RunResult& run : result.runs) {
    for (const TaskRecord& task : run.run->record.tasks) {
      for (const Record& record : task.*table) {
        const auto is_this = [&](const Record& other) { return is_same(record, other); };
        if (std::ranges::none_of(found, is_this)) found.push_back(record);
      }
    }
  }
  return found;
}

bool IsSameMetric(const CurveRecord& a, const CurveRecord& b) {
  return a.name == b.name && a.unit == b.unit;
}
bool IsSameTerm(const TermRecord& a, const TermRecord& b) { return a.name == b.name; }

}  // namespace

ValueCurves ValueCurvesOf(const ExperimentResult& result, const std::vector<double>& episodes) {
  ValueCurves curves;
  for (const CurveRecord& metric : Collect(result, &TaskRecord::metrics, IsSameMetric)) {
    const EpisodeValue value = [&](const RunRecord& run, const EpisodeRecord& episode) {
      const Evaluation& active = episode.active;
      return Find(TaskWithId(run, active.task).metrics, active.metrics,
                  [&](const CurveRecord& other) { return IsSameMetric(metric, other); });
    };
    curves.metrics.push_back({metric.name, metric.unit, MeansOf(result, episodes, value)});
  }
  for (const TermRecord& term : Collect(result, &TaskRecord::terms, IsSameTerm)) {
    const EpisodeValue value = [&](const RunRecord& run, const EpisodeRecord& episode) {
      const Evaluation& active = episode.active;
      return Find(TaskWithId(run, active.task).terms, active.terms,
                  [&](const TermRecord& other) { return IsSameTerm(term, other); });
    };
    curves.terms.push_back({term.name, "", MeansOf(result, episodes, value)});
  }
  return curves;
}

}  // namespace runtime
