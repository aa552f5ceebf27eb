#include "runtime/analysis/report/goals_told.h"

namespace runtime {

using nlohmann::json;

json GoalsTold(const TaskRecord& task, const Evaluation& evaluation) {
  json told = json::array();
  for (const GoalDraw& draw : evaluation.goals) {
    const GoalRecord& goal = task.goals[draw.goal];
    told.push_back({{"time", draw.time},
                    {"name", goal.name},
                    {"type", goal.type},
                    {"unit", goal.unit},
                    {"value", draw.value}});
  }
  return told;
}

}  // namespace runtime
