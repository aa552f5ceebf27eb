#include "libtaskc/episode.h"

#include <span>

namespace libtaskc {

Episode::Episode(const taskc_plugin& task) : task_(task) {
  for (const taskc_requirement& each : std::span(task.requirements, task.requirement_count))
    violation_reasons_.push_back(std::string("requirement: ") + each.reason);
}

void Episode::Initialize() {
  if (is_initialized_) return;
  frame().Initialize();
  is_initialized_ = true;
}

taskc_result Episode::Start(taskc_uint64 seed) {
  frame().SetSeed(seed);
  Initialize();
  task_.Start();
  fault_count_ = 0;
  kind_ = end_ = violation_ = -1;
  is_running_ = true;
  const taskc_result result = Call(TASKC_START_OF_EPISODE, 0);
  return_ = 0;  // a learner does not count what is paid before its first action either
  return result;
}

taskc_result Episode::End(taskc_int32 outcome) {
  if (kind_ < 0) kind_ = outcome;
  frame().SetOutcome(kind_);
  is_running_ = false;
  taskc_result result = Call(TASKC_END_OF_EPISODE, 0);
  result.end = result.violation = -1;  // the episode has ended already
  return result;
}

taskc_result Episode::NoteIncident() {
  const host::EventOutcome outcome = task_.Outcome();
  return_ += outcome.reward;
  if (outcome.fault >= 0) ++fault_count_;
  if (!outcome.is_paid) ++fault_count_;
  taskc_result result{outcome.reward, -1, -1, outcome.fault};
  if (is_over()) return result;
  result.violation = violation_ = outcome.violation;
  if (violation_ >= 0) {
    kind_ = TASKC_TRUNCATED;
  } else if (outcome.end >= 0) {
    result.end = end_ = outcome.end;
    kind_ = frame().plugin().ends[end_].kind;
  }
  return result;
}

const char* Episode::reason() const {
  if (violation_ >= 0) return violation_reasons_[static_cast<size_t>(violation_)].c_str();
  if (end_ >= 0) return frame().plugin().ends[end_].reason;
  return kind_ >= 0 ? "" : nullptr;
}

}  // namespace libtaskc
