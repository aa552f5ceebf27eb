#include "compiler/bounds/start_bounds.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "compiler/bounds/bounds_text.h"
#include "compiler/bounds/event_bounds.h"
#include "compiler/bounds/memory_bounds.h"
#include "compiler/check/report.h"
#include "compiler/check/traversal.h"

namespace compiler {
namespace {

constexpr Unit kRadians{.radian = 1};

// Bounds have a few digits to spare.
constexpr double kSpareAngle = 1e-9;  // [rad]

// The values after the block, from those of all poses.
Values ValuesAfter(const CheckedTask& task) {
  Values values = ValuesAtStart(task, EventKind::kStartOfEpisode, {});
  values.memory = MemoryBounds(task, {});
  for (const CheckedStartValue& value : task.start.values) {
    std::vector<Interval> elements;
    for (size_t i = 0; i < value.minimum.size(); ++i)
      elements.push_back({value.minimum[i], value.maximum[i]});
    values.memory[value.memory] = MakeBox(std::move(elements));
  }
  return EventBounds(task, nullptr).Run(task.start.block, std::move(values));
}

// The last statement that sets the memory: what it leaves is what the robot starts with.
Span LastAssignment(const CheckedTask& task, uint32_t memory) {
  Span last = task.start.span;
  ForEachStatement(task.start.block.body, [&](const CheckedStatement& statement) {
    const auto* assign = std::get_if<CheckedAssign>(&statement.node);
    if (assign != nullptr && assign->memory == memory) last = statement.span;
  });
  return last;
}

std::string PlaceText(double angle) {
  return std::abs(angle) == kInfinity ? "anywhere" : "at " + RangeText(Exactly(angle), kRadians);
}

bool IsWithin(const Interval& angle, double low, double high) {
  return angle.low >= low - kSpareAngle && angle.high <= high + kSpareAngle && !angle.may_be_nan;
}

}  // namespace

void CheckStops(const CheckedTask& task, Diagnostics& diagnostics) {
  const CheckedStart& start = task.start;
  const auto angle =
      std::ranges::find(start.values, StartValue::kJointAngle, &CheckedStartValue::value);
  if (angle == start.values.end()) return;
  const Values after = ValuesAfter(task);
  const Box& angles = after.memory[angle->memory];
  std::vector<size_t> beyond;
  for (size_t i = 0; i < start.joints.size(); ++i)
    if (!IsWithin(angles[i], start.low[i], start.high[i])) beyond.push_back(i);
  if (beyond.empty()) return;
  const size_t first = beyond.front();
  const bool is_low = angles[first].low < start.low[first] - kSpareAngle;
  const size_t others = beyond.size() - 1;
  Report(diagnostics, code::kStartBeyondStop, LastAssignment(task, angle->memory),
         fmt::format("`{}` can start {}, beyond its stop {}{}", start.joints[first],
                     PlaceText(is_low ? angles[first].low : angles[first].high),
                     PlaceText(is_low ? start.low[first] : start.high[first]),
                     others == 0 ? ""
                                 : fmt::format(", and so can {} other joint{}", others,
                                               others == 1 ? "" : "s")),
         {.help = "keep it between its stops: `joint.angle = clamp(joint.angle, joint.low, "
                  "joint.high)`"});
}

}  // namespace compiler
