#include "compiler/bounds/memory_bounds.h"

#include <algorithm>
#include <set>
#include <utility>

#include "compiler/bounds/event_bounds.h"
#include "compiler/bounds/expression_bounds.h"
#include "compiler/check/traversal.h"

namespace compiler {
namespace {

// Bounds that grow are looked at again this often before they jump to the next landmark, and only
// so many times before they jump to infinity. What has jumped a few times hardly ever comes to rest
// by itself: from then on it jumps in each round.
constexpr int kRoundsBetweenJumps = 3;
constexpr int kPatientJumps = 8;
constexpr int kMostJumps = 20;
// What jumped too far is drawn in again so often.
constexpr int kRoundsBack = 2;

Interval Within(const Interval& range, double limit) { return Meet(range, {-limit, limit}); }

Box SensorBox(const CheckedSensor& sensor, const Assumptions& assumptions) {
  const uint32_t size = sensor.type.size();
  std::vector<Interval> elements(size,
                                 Within(AnyOf(sensor.type.scalar), assumptions.without_range));
  for (uint32_t i = 0; i < std::min<size_t>(size, sensor.minimum.size()); ++i) {
    elements[i] = Meet(elements[i], {sensor.minimum[i], sensor.maximum[i]});
    if (sensor.is_nominal && sensor.minimum[i] == -sensor.maximum[i])
      elements[i] = Within(elements[i], assumptions.share_of_nominal * sensor.maximum[i]);
  }
  return MakeBox(std::move(elements));
}

Box ParamBox(const CheckedParam& param, const Assumptions& assumptions) {
  if (assumptions.has_initial_params) return Box(Exactly(param.initial));
  if (param.type.scalar == Scalar::kBool) return Box(kAnyBool);
  return Box(Within({param.minimum, param.maximum}, assumptions.without_range));
}

bool SetsMemory(const CheckedEvent& event) {
  bool sets = false;
  ForEachStatement(event.body, [&](const CheckedStatement& statement) {
    if (std::holds_alternative<CheckedAssign>(statement.node) ||
        std::holds_alternative<CheckedRedraw>(statement.node) ||
        std::holds_alternative<CheckedPhaseSwitch>(statement.node) ||
        std::holds_alternative<CheckedAdvance>(statement.node) ||
        std::holds_alternative<CheckedPotentialStep>(statement.node))
      sets = true;
  });
  return sets;
}

// Numbers at which bounds often come to rest: those that the task compares with.
std::vector<double> LandmarksOf(const CheckedTask& task) {
  std::set<double> landmarks;
  const auto add = [&](double value) { landmarks.insert({value - 1, value, value + 1}); };
  for (const CheckedEvent& event : task.events)
    ForEachStatement(event.body, [&](const CheckedStatement& statement) {
      ForEachExpression(statement, [&](const CheckedExpression& expression) {
        ForEachPart(expression, [&](const CheckedExpression& part) {
          if (const auto* constant = std::get_if<Constant>(&part.node)) add(constant->value);
        });
      });
    });
  for (const CheckedParam& param : task.params) {
    add(param.minimum);
    add(param.maximum);
  }
  return {landmarks.begin(), landmarks.end()};
}

class MemoryFixpoint {
 public:
  MemoryFixpoint(const CheckedTask& task, const Assumptions& assumptions)
      : task_(task), assumptions_(assumptions), landmarks_(LandmarksOf(task)), initial_(Initial()) {
    for (size_t i = 0; i < task.events.size(); ++i) {
      if (SetsMemory(task.events[i]))
        setting_.push_back(
            {task.events[i], ValuesAtStart(task, static_cast<EventKind>(i), assumptions)});
    }
  }

  std::vector<Box> Find() const {
    std::vector<Box> memory = initial_;
    int jumps = 0;
    for (int round = 1;; ++round) {
      std::vector<Box> grown = Join(memory, AfterAnyEvent(memory));
      if (grown == memory) break;
      if (jumps >= kPatientJumps || round % kRoundsBetweenJumps == 0)
        Jump(memory, grown, ++jumps <= kMostJumps);
      memory = std::move(grown);
    }
    for (int i = 0; jumps > 0 && i < kRoundsBack; ++i) memory = AfterAnyEvent(memory);
    return memory;
  }

 private:
  // An event that sets memory, and what is known when it begins, besides that of memory.
  struct SettingEvent {
    const CheckedEvent& event;
    Values start;
  };

  // Goals are drawn as soon as all else has its first value.
  std::vector<Box> Initial() const {
    Values values = ValuesAtStart(task_, EventKind::kStartOfEpisode, assumptions_);
    for (const CheckedMemory& memory : task_.memory) {
      const Interval first = ExpressionBounds(task_, values).Of(memory.initial);
      values.memory.push_back(MakeBox(std::vector<Interval>(memory.type.size(), first)));
    }
    for (const CheckedGoal& goal : task_.goals)
      values.memory[goal.memory] = GoalBounds(task_, values, goal);
    // No statement sets it.
    if (task_.ended) values.memory[*task_.ended] = Box(kAnyBool);
    SetTimeFunctions(values);
    return values.memory;
  }

  // They have their first values when an episode starts, before anything reads them.
  void SetTimeFunctions(Values& values) const {
    const CheckedEvent& start = task_.events[static_cast<size_t>(EventKind::kStartOfEpisode)];
    for (const CheckedStatement& statement : start.body) {
      const auto* advance = std::get_if<CheckedAdvance>(&statement.node);
      if (advance == nullptr) continue;
      const CheckedTimeFunction& function = task_.time_functions[advance->function];
      values.memory[function.value] = TimeFunctionBounds(
          function.function, ExpressionBounds(task_, values).AllOf(advance->value),
          advance->value.type.scalar, task_.longest_time_step);
    }
  }

  // Also reset, or left alone by what sets nothing.
  std::vector<Box> AfterAnyEvent(const std::vector<Box>& before) const {
    std::vector<Box> after = initial_;
    for (const SettingEvent& setting : setting_) {
      Values values = setting.start;
      values.memory = before;
      values = EventBounds(task_, nullptr).Run(setting.event, std::move(values));
      after = Join(after, values.memory);
    }
    return after;
  }

  void Jump(const std::vector<Box>& from, std::vector<Box>& to, bool to_landmarks) const {
    for (size_t i = 0; i < to.size(); ++i)
      for (size_t j = 0; j < to[i].size() && !to[i].IsCopyOf(from[i]); ++j) {
        Interval end = to[i][j];
        if (end.low < from[i][j].low) end.low = to_landmarks ? LandmarkBelow(end.low) : -kInfinity;
        if (end.high > from[i][j].high)
          end.high = to_landmarks ? LandmarkAbove(end.high) : kInfinity;
        to[i].Set(j, end);
      }
  }

  double LandmarkAbove(double value) const {
    const auto next = std::ranges::lower_bound(landmarks_, value);
    return next == landmarks_.end() ? kInfinity : *next;
  }

  double LandmarkBelow(double value) const {
    const auto next = std::ranges::upper_bound(landmarks_, value);
    return next == landmarks_.begin() ? -kInfinity : *std::prev(next);
  }

  const CheckedTask& task_;
  const Assumptions& assumptions_;
  std::vector<double> landmarks_;
  std::vector<Box> initial_;
  std::vector<SettingEvent> setting_;
};

}  // namespace

Values ValuesAtStart(const CheckedTask& task, EventKind event, const Assumptions& assumptions) {
  Values values;
  for (const CheckedSensor& sensor : task.sensors)
    values.sensors.push_back(SensorBox(sensor, assumptions));
  for (const CheckedParam& param : task.params)
    values.params.push_back(ParamBox(param, assumptions));
  const bool has_time_step = event >= EventKind::kStartOfTimeStep;
  values.time_step = {
      0, has_time_step ? std::min(task.longest_time_step, assumptions.without_range) : 0};
  return values;
}

std::vector<Box> MemoryBounds(const CheckedTask& task, const Assumptions& assumptions) {
  return MemoryFixpoint(task, assumptions).Find();
}

}  // namespace compiler
