#include "runtime/trainer/reproduce/episode_difference.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace runtime {
namespace {

constexpr const char* kNothing = "nothing";

class EpisodeComparison {
 public:
  void Texts(const std::string& name, const std::string& recorded, const std::string& here) {
    if (recorded != here) found_.push_back({prefix_ + name, recorded, here});
  }

  void Numbers(const std::string& name, double recorded, double here) {
    const bool are_equal = recorded == here || (std::isnan(recorded) && std::isnan(here));
    if (!are_equal) Texts(name, NumberText(recorded), NumberText(here));
  }

  void Counts(const std::string& name, int64_t recorded, int64_t here) {
    if (recorded != here) Texts(name, fmt::format("{}", recorded), fmt::format("{}", here));
  }

  // `kind`: "term".
  template <class Part>
  void Parts(const char* kind, const std::vector<Part>& parts, const std::vector<double>& recorded,
             const std::vector<double>& here) {
    Counts(fmt::format("number of {}s", kind), static_cast<int64_t>(recorded.size()),
           static_cast<int64_t>(here.size()));
    const size_t count = std::min({parts.size(), recorded.size(), here.size()});
    for (size_t i = 0; i < count; ++i) {
      Numbers(fmt::format("{} {}", kind, parts[i].name), recorded[i], here[i]);
    }
  }

  void Evaluations(const Evaluation& recorded, const Evaluation& here, const TaskRecord& task) {
    Texts("end", EndText(recorded), EndText(here));
    Numbers("return", recorded.episode_return, here.episode_return);
    Parts("term", task.terms, recorded.terms, here.terms);
    Parts("metric", task.metrics, recorded.metrics, here.metrics);
    Parts("log", task.logs, recorded.logs, here.logs);
    Goals(recorded.goals, here.goals, task);
    Phases(recorded.phases, here.phases, task);
    Counts("faults", recorded.faults, here.faults);
    Counts("violations", recorded.violations, here.violations);
  }

  void StartShadow(const TaskRecord& task) { prefix_ = task.module + ": "; }
  std::vector<ValueDifference> Take() { return std::move(found_); }

 private:
  static std::string NumberText(double number) {
    return std::isnan(number) ? kNothing : fmt::format("{}", number);
  }
  static std::string EndText(const Evaluation& evaluation) {
    return evaluation.end_reason.empty()
               ? evaluation.end_kind
               : fmt::format("{}: {}", evaluation.end_kind, evaluation.end_reason);
  }
  static std::string DrawText(const GoalDraw& draw) {
    return fmt::format("{} at {} s", draw.value, draw.time);
  }

  void Goals(const std::vector<GoalDraw>& recorded, const std::vector<GoalDraw>& here,
             const TaskRecord& task) {
    Counts("number of goals told", static_cast<int64_t>(recorded.size()),
           static_cast<int64_t>(here.size()));
    for (size_t i = 0; i < std::min(recorded.size(), here.size()); ++i) {
      if (recorded[i] == here[i]) continue;
      Texts(fmt::format("goal {}", task.goals.at(recorded[i].goal).name), DrawText(recorded[i]),
            DrawText(here[i]));
    }
  }

  void Phases(const std::vector<PhaseSums>& recorded, const std::vector<PhaseSums>& here,
              const TaskRecord& task) {
    for (size_t i = 0; i < std::min({recorded.size(), here.size(), task.phases.size()}); ++i) {
      const std::string& name = task.phases[i].name;
      Numbers(fmt::format("time of phase {}", name), recorded[i].time, here[i].time);
      Numbers(fmt::format("return of phase {}", name), recorded[i].reward, here[i].reward);
    }
  }

  std::string prefix_;
  std::vector<ValueDifference> found_;
};

// What a learner shows is recorded as far as it is a number.
double ValueCalled(const std::string& name, const std::vector<NamedValue>& values) {
  const auto found = std::ranges::find(values, name, &NamedValue::name);
  return found == values.end() ? std::nan("") : found->value;
}

std::string TaskText(int64_t id, const RunRecord& run) { return VersionText(TaskWithId(run, id)); }

}  // namespace

std::vector<ValueDifference> DifferencesOf(const EpisodeRecord& recorded, const EpisodeRecord& here,
                                           const RunRecord& run) {
  EpisodeComparison comparison;
  comparison.Counts("steps", recorded.steps, here.steps);
  comparison.Counts("actions", recorded.actions, here.actions);
  comparison.Numbers("simulated seconds", recorded.simulated_seconds, here.simulated_seconds);
  comparison.Counts("number of shadows", static_cast<int64_t>(recorded.shadows.size()),
                    static_cast<int64_t>(here.shadows.size()));
  if (recorded.active.task != here.active.task) {
    comparison.Texts("task", TaskText(recorded.active.task, run), TaskText(here.active.task, run));
    return comparison.Take();
  }
  comparison.Evaluations(recorded.active, here.active, TaskWithId(run, here.active.task));
  for (const NamedValue& each : recorded.learner) {
    comparison.Numbers(each.name, each.value, ValueCalled(each.name, here.learner));
  }
  for (const Evaluation& shadow : here.shadows) {
    const auto found = std::ranges::find(recorded.shadows, shadow.task, &Evaluation::task);
    if (found == recorded.shadows.end()) continue;
    comparison.StartShadow(TaskWithId(run, shadow.task));
    comparison.Evaluations(*found, shadow, TaskWithId(run, shadow.task));
  }
  return comparison.Take();
}

}  // namespace runtime
