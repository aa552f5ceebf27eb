#include "runtime/training/run/task_record.h"

#include <cstdlib>
#include <utility>

namespace runtime {
namespace {

const char* ReductionName(taskc_int32 reduction) {
  switch (reduction) {
    case TASKC_LAST:
      return "last";
    case TASKC_SUM:
      return "sum";
    case TASKC_MAX:
      return "max";
    case TASKC_MIN:
      return "min";
    case TASKC_MEAN:
      return "mean";
  }
  std::abort();  // a plugin with another one is not loaded
}

}  // namespace

TaskRecord DescribeTask(const taskc_plugin& plugin, std::string module) {
  TaskRecord task;
  task.module = std::move(module);
  task.task = plugin.name;
  task.task_file = plugin.sources[0].file;
  task.task_hash = plugin.source_hash;
  task.compiler = plugin.compiler;
  for (taskc_uint32 i = 0; i < plugin.term_count; ++i) {
    task.terms.push_back({plugin.terms[i].name, plugin.terms[i].doc});
  }
  for (taskc_uint32 i = 0; i < plugin.metric_count; ++i) {
    const taskc_metric& metric = plugin.metrics[i];
    task.metrics.push_back({metric.name, metric.unit, ReductionName(metric.reduction), metric.doc});
  }
  for (taskc_uint32 i = 0; i < plugin.log_count; ++i) {
    const taskc_log& log = plugin.logs[i];
    task.logs.push_back({log.name, log.unit, ReductionName(log.reduction), log.doc});
  }
  for (taskc_uint32 i = 0; i < plugin.goal_count; ++i) {
    const taskc_goal& goal = plugin.goals[i];
    task.goals.push_back({goal.name, goal.type, goal.unit, goal.doc});
  }
  for (taskc_uint32 i = 0; i < plugin.phase_count; ++i) {
    task.phases.push_back({plugin.phases[i].name, plugin.phases[i].doc});
  }
  for (taskc_uint32 i = 0; i < plugin.source_count; ++i) {
    task.sources.push_back({plugin.sources[i].file, plugin.sources[i].text});
  }
  return task;
}

}  // namespace runtime
