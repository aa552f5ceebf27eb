#include "runtime/analysis/study/learning.h"

#include <algorithm>
#include <cmath>

#include "runtime/training/run/estimate.h"

namespace runtime {
namespace {

constexpr double kMost = 0.8;
constexpr double kClear = 3;  // standard errors
class Mean {
 public:
  void Add(double value) { Count(value, 1); }
  void Remove(double value) { Count(value, -1); }
  double value() const { return count_ > 0 ? sum_ / count_ : kNoNumber; }

 private:
  void Count(double value, int sign) {
    if (std::isnan(value)) return;
    sum_ += sign * value;
    count_ += sign;
  }

  double sum_ = 0;
  int count_ = 0;
};

// By how much the means of two windows differ where nothing was learned, as a standard deviation.
// Half of the squared difference between two returns in a row is the variance of one, whatever is
// learned meanwhile: that happens over many episodes.
double ErrorOfProgress(std::span<const EpisodeRecord> episodes, int64_t window) {
  Mean squares;
  for (size_t i = 1; i < episodes.size(); ++i) {
    const double step = episodes[i].active.episode_return - episodes[i - 1].active.episode_return;
    squares.Add(step * step);
  }
  return std::sqrt(squares.value() / static_cast<double>(window));
}

template <class Record>
void AddByName(const std::vector<Record>& records, const std::vector<double>& values,
               std::map<std::string, Mean>& means) {
  for (size_t i = 0; i < values.size(); ++i) means[records[i].name].Add(values[i]);
}

std::map<std::string, double> ValuesOf(const std::map<std::string, Mean>& means) {
  std::map<std::string, double> values;
  for (const auto& [name, mean] : means) {
    if (!std::isnan(mean.value())) values[name] = mean.value();
  }
  return values;
}

}  // namespace

int64_t MeanWindow(int64_t episodes_planned) {
  return std::clamp<int64_t>(episodes_planned / 20, 1, 50);
}

std::vector<double> MovingAverage(std::span<const double> values, int64_t window) {
  std::vector<double> averages;
  Mean mean;
  for (size_t i = 0; i < values.size(); ++i) {
    mean.Add(values[i]);
    const auto before = static_cast<int64_t>(i) - window;
    if (before >= 0) mean.Remove(values[static_cast<size_t>(before)]);
    averages.push_back(mean.value());
  }
  return averages;
}

std::vector<double> MovingAverage(std::span<const EpisodeRecord> episodes, int64_t window) {
  std::vector<double> returns;
  returns.reserve(episodes.size());
  for (const EpisodeRecord& episode : episodes) returns.push_back(episode.active.episode_return);
  return MovingAverage(returns, window);
}

std::optional<MostLearned> FindMostLearned(std::span<const EpisodeRecord> episodes,
                                           int64_t window) {
  if (static_cast<int64_t>(episodes.size()) < 2 * window) return std::nullopt;
  const std::vector<double> averages = MovingAverage(episodes, window);
  const auto begin = static_cast<size_t>(window - 1);
  const double first = averages[begin];
  const double last = averages.back();
  if (!(last - first > kClear * ErrorOfProgress(episodes, window))) return std::nullopt;
  double cpu_seconds = 0;
  for (size_t i = 0; i < averages.size(); ++i) {
    cpu_seconds += episodes[i].cpu_seconds;
    if (i < begin || averages[i] < first + kMost * (last - first)) continue;
    return MostLearned{episodes[i].number, cpu_seconds};
  }
  return std::nullopt;
}

FinalMeans MeansAtTheEnd(const RunRecord& run, std::span<const EpisodeRecord> episodes,
                         int64_t window) {
  Mean returns;
  std::map<std::string, Mean> terms;
  std::map<std::string, Mean> metrics;
  for (const EpisodeRecord& episode :
       episodes.last(std::min(episodes.size(), static_cast<size_t>(window)))) {
    const TaskRecord& task = TaskWithId(run, episode.active.task);
    returns.Add(episode.active.episode_return);
    AddByName(task.terms, episode.active.terms, terms);
    AddByName(task.metrics, episode.active.metrics, metrics);
  }
  return {returns.value(), ValuesOf(terms), ValuesOf(metrics)};
}

}  // namespace runtime
