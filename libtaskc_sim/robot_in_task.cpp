#include "libtaskc_sim/robot_in_task.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "libtaskc_sim/failure.h"
#include "runtime/training/learning/terminal_end.h"
#include "runtime/training/simulation/ode_library.h"

namespace libtaskc_sim {
namespace {

template <class Value>
void Write(Value value, Value* out) {
  if (out != nullptr) *out = value;
}

}  // namespace

RobotInTask::RobotInTask(const runtime::TaskSetup& setup, double discount, size_t index,
                         const Common& common)
    : process_(setup, discount),
      index_(index),
      common_(common),
      action_(Eigen::VectorXd::Zero(process_.action_size())) {}

int64_t RobotInTask::NextNumber() const {
  return was_reset() ? process_.number() + static_cast<int64_t>(common_.count)
                     : static_cast<int64_t>(index_) + 1;
}

std::exception_ptr RobotInTask::TakeFailure() { return std::exchange(failure_, nullptr); }

void RobotInTask::Reset(int64_t number, float* observation) noexcept {
  try {
    runtime::UseOdeInThisThread();
    Begin(number, observation);
  } catch (...) {
    failure_ = std::current_exception();
  }
}

void RobotInTask::Step(const float* action, const Results& results) noexcept {
  try {
    runtime::UseOdeInThisThread();  // the world may have been made in another one
    Decide(action, results);
  } catch (...) {
    failure_ = std::current_exception();
  }
}

void RobotInTask::Begin(int64_t number, float* observation) {
  process_.Reset(number);
  if (!process_.is_running()) {
    has_record_ = true;
    throw Failure(TASKC_SIM_ERROR_EPISODE,
                  fmt::format("environment {}: episode {} ends where it begins: {}", index_, number,
                              process_.record().active.end_reason));
  }
  WriteObservation(observation);
}

void RobotInTask::Decide(const float* action, const Results& results) {
  const bool begins = !process_.is_running();
  if (begins) {
    Begin(NextNumber(), nullptr);
  } else {
    std::copy_n(action, action_.size(), action_.begin());
    process_.Step(action_);
  }
  const bool is_over = has_ended_ = !process_.is_running();
  const bool is_terminal = is_over && runtime::IsTerminal(process_.end_kind());
  Write(begins ? 0 : process_.reward(), results.reward);
  Write<unsigned char>(is_terminal, results.terminated);
  Write<unsigned char>(is_over && !is_terminal, results.truncated);
  if (results.term_sums != nullptr) {
    std::ranges::copy(process_.task().term_sums(), results.term_sums);
  }
  if (!is_over) return WriteObservation(results.observation);
  has_record_ = true;
  WriteObservation(results.final_observation);
  if (common_.autoreset == TASKC_SIM_SAME_STEP) {
    Begin(NextNumber(), results.observation);
  } else {
    WriteObservation(results.observation);
  }
}

void RobotInTask::WriteObservation(float* out) const {
  if (out == nullptr) return;
  std::ranges::transform(process_.observation(), out,
                         [](double value) { return static_cast<float>(value); });
}

}  // namespace libtaskc_sim
