#include "libtaskc_sim/ended_episode.h"

namespace libtaskc_sim {
namespace {

taskc_int32 KindOf(runtime::EndKind kind) {
  switch (kind) {
    case runtime::EndKind::kSuccess:
      return TASKC_SUCCESS;
    case runtime::EndKind::kFailure:
      return TASKC_FAILURE;
    case runtime::EndKind::kTruncated:
      return TASKC_TRUNCATED;
    case runtime::EndKind::kDiverged:
      break;
  }
  return TASKC_SIM_DIVERGED;
}

template <class Value>
void Put(Value* column, size_t environment, Value value) {
  if (column != nullptr) column[environment] = value;
}

}  // namespace

taskc_sim_episode EpisodeOf(const RobotInTask& robot) {
  const runtime::DecisionProcess& process = robot.process();
  const runtime::EpisodeRecord& record = process.record();
  const runtime::Evaluation& task = record.active;
  return {record.number,
          record.actions,
          record.steps,
          record.simulated_seconds,
          task.episode_return,
          KindOf(process.end_kind()),
          task.end_reason.c_str(),
          task.faults,
          task.terms.data(),
          task.metrics.data(),
          task.logs.data()};
}

void EndColumns::Write(size_t environment, const taskc_sim_episode& episode) const {
  Put(ends_.numbers, environment, episode.number);
  Put(ends_.kinds, environment, episode.kind);
  Put(ends_.reasons, environment, episode.reason);
  Put(ends_.returns, environment, episode.episode_return);
  Put(ends_.seconds, environment, episode.seconds);
  WriteTo(ends_.terms, environment, episode.terms, task_.term_count);
  WriteTo(ends_.metrics, environment, episode.metrics, task_.metric_count);
  WriteTo(ends_.logs, environment, episode.logs, task_.log_count);
}

void EndColumns::Clear(size_t environment) const {
  taskc_sim_episode none{};
  none.kind = -1;
  Write(environment, none);
}

void EndColumns::WriteTo(double* columns, size_t environment, const double* values,
                         size_t size) const {
  if (columns == nullptr) return;
  for (size_t i = 0; i < size; ++i) {
    columns[i * count_ + environment] = values == nullptr ? 0 : values[i];
  }
}

}  // namespace libtaskc_sim
