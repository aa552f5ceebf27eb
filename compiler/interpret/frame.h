// What a task reads and writes: the evaluator's counterpart of `taskc_frame`.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/check/value.h"

namespace compiler {

// What has been logged; without a value (`count` is 0) the other members mean nothing.
struct LogState {
  int64_t count = 0;
  double last = 0;
  double sum = 0;
  double minimum = 0;
  double maximum = 0;
};

// Lists are indexed like those of the task.
struct Frame {
  // Sensors 0 and false, params and memory as they begin.
  explicit Frame(const CheckedTask& task);

  std::vector<Value> sensors;
  std::vector<double> params;  // as a host passes them: a double, whatever the type
  std::vector<Value> memory;
  uint64_t seed = 0;
  int32_t pose = 0;      // that a start has drawn
  uint32_t attempt = 0;  // of a start: how often it was drawn for this episode before
  double time_step = 0;
  double discount = 1;
  EndKind outcome = EndKind::kTruncated;
  std::vector<double> terms;
  std::vector<double> metrics;
  std::vector<double> observations;
  std::vector<LogState> logs;
  // What the last callback did; -1: nothing of that kind.
  double reward = 0;
  int32_t end = -1;
  int32_t fault = -1;
  int32_t violation = -1;
  // The first of that kind since the frame was made, or -1.
  int32_t first_end = -1;
  int32_t first_violation = -1;
  // What `value(NAME)` reads: what would be recorded if the episode ended now. A test's business;
  // only a metric that is reduced to its last value is computed when it is read.
  std::vector<double> recorded_metrics;
  std::vector<double> recorded_logs;
};

}  // namespace compiler
