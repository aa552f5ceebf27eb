#include "runtime/run/task_record.h"

#include <cstdlib>

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

void DescribeTask(const taskc_plugin& plugin, RunRecord& run) {
  run.task = plugin.name;
  run.task_file = plugin.sources[0].file;
  run.task_hash = plugin.source_hash;
  run.compiler = plugin.compiler;
  for (taskc_uint32 i = 0; i < plugin.term_count; ++i) {
    run.terms.push_back({plugin.terms[i].name, plugin.terms[i].doc});
  }
  for (taskc_uint32 i = 0; i < plugin.metric_count; ++i) {
    const taskc_metric& metric = plugin.metrics[i];
    run.metrics.push_back({metric.name, metric.unit, ReductionName(metric.reduction), metric.doc});
  }
  for (taskc_uint32 i = 0; i < plugin.log_count; ++i) {
    const taskc_log& log = plugin.logs[i];
    run.logs.push_back({log.name, log.unit, ReductionName(log.reduction), log.doc});
  }
  for (taskc_uint32 i = 0; i < plugin.source_count; ++i) {
    run.sources.push_back({plugin.sources[i].file, plugin.sources[i].text});
  }
}

}  // namespace runtime
