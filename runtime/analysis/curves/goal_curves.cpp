#include "runtime/analysis/curves/goal_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

namespace runtime {
namespace {

// By the task's id: how many elements each of its goals has.
using Sizes = std::map<int64_t, std::vector<size_t>>;

Sizes SizesOfGoals(const RunRecord& run, const std::vector<EpisodeRecord>& episodes) {
  Sizes sizes;
  for (const TaskRecord& task : run.tasks) sizes[task.id].resize(task.goals.size());
  for (const EpisodeRecord& episode : episodes) {
    std::vector<size_t>& of_task = sizes[episode.active.task];
    for (const GoalDraw& draw : episode.active.goals) of_task[draw.goal] = draw.value.size();
  }
  return sizes;
}

// "command.x", "place[2]"; of a single number the goal's name.
std::string ElementName(const GoalRecord& goal, size_t element, size_t size) {
  if (size == 1) return goal.name;
  const bool is_quaternion = goal.type == "quat";
  if (is_quaternion || (goal.type.starts_with("vec") && size <= 4)) {
    return fmt::format("{}.{}", goal.name, (is_quaternion ? "wxyz" : "xyzw")[element]);
  }
  return fmt::format("{}[{}]", goal.name, element);
}

std::vector<CurveRecord> Elements(const TaskRecord& task, const std::vector<size_t>& sizes) {
  std::vector<CurveRecord> records;
  for (size_t goal = 0; goal < task.goals.size(); ++goal) {
    const GoalRecord& record = task.goals[goal];
    for (size_t element = 0; element < sizes[goal]; ++element) {
      records.push_back(
          {ElementName(record, element, sizes[goal]), record.unit, "mean", record.doc});
    }
  }
  return records;
}

std::vector<const GoalDraw*> DrawsOf(size_t goal, const Evaluation& evaluation) {
  std::vector<const GoalDraw*> draws;
  for (const GoalDraw& draw : evaluation.goals) {
    if (draw.goal == goal) draws.push_back(&draw);
  }
  return draws;
}

// The mean of each of the goal's elements over the time of the episode [s]; not a number where the
// goal was never drawn.
std::vector<double> MeanOf(const std::vector<const GoalDraw*>& draws, double duration,
                           size_t size) {
  if (draws.size() == 1) return draws[0]->value;
  std::vector<double> mean(size);
  double length = 0;
  for (size_t i = 0; i < draws.size(); ++i) {
    const double until = i + 1 < draws.size() ? draws[i + 1]->time : duration;
    const double weight = std::max(0.0, until - draws[i]->time);
    for (size_t j = 0; j < size; ++j) mean[j] += weight * draws[i]->value[j];
    length += weight;
  }
  for (double& element : mean) element /= length;
  return mean;
}

std::vector<double> Means(const EpisodeRecord& episode, const std::vector<size_t>& sizes) {
  std::vector<double> means;
  for (size_t goal = 0; goal < sizes.size(); ++goal) {
    const std::vector<double> mean =
        MeanOf(DrawsOf(goal, episode.active), episode.simulated_seconds, sizes[goal]);
    means.insert(means.end(), mean.begin(), mean.end());
  }
  return means;
}

}  // namespace

std::vector<Curve> GoalCurves(const RunRecord& run, const std::vector<EpisodeRecord>& episodes) {
  const Sizes sizes = SizesOfGoals(run, episodes);
  return TaskCurves(
      run, episodes, [&](const TaskRecord& task) { return Elements(task, sizes.at(task.id)); },
      [&](const EpisodeRecord& episode) { return Means(episode, sizes.at(episode.active.task)); });
}

}  // namespace runtime
