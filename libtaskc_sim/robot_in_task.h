// One environment of a `taskc_sim`.
#pragma once

#include <taskc/sim.h>

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>

#include "runtime/trainer/environment/decision_process.h"
#include "runtime/trainer/setup/task_setup.h"

namespace libtaskc_sim {

// What all environments of a `taskc_sim` have in common.
struct Common {
  taskc_int32 autoreset = TASKC_SIM_NEXT_STEP;
  size_t count = 1;
};

// Where one environment's part of the results goes; each may be null.
struct Results {
  float* observation = nullptr;
  float* final_observation = nullptr;
  double* reward = nullptr;
  unsigned char* terminated = nullptr;
  unsigned char* truncated = nullptr;
  double* term_sums = nullptr;
};

class RobotInTask {
 public:
  // It is environment number `index`. `setup` outlives this object. Throws UserError.
  RobotInTask(const runtime::TaskSetup& setup, double discount, size_t index, const Common& common);

  const runtime::DecisionProcess& process() const { return process_; }
  bool was_reset() const { return process_.number() > 0; }
  // Whether an episode has ended here, with its record; and whether one has in the last step.
  bool has_record() const { return has_record_; }
  bool has_ended() const { return has_ended_; }

  // Throws as DecisionProcess::Set().
  void Set(const std::string& parameter, const runtime::ParameterValue& value) {
    process_.Set(parameter, value);
  }

  // The number of the episode that follows without a seed.
  int64_t NextNumber() const;

  // Both keep what is thrown, for TakeFailure(). Failure with TASKC_SIM_ERROR_EPISODE where an
  // episode ends where it begins.
  void Reset(int64_t number, float* observation) noexcept;
  void Step(const float* action, const Results& results) noexcept;
  // What the last one has thrown; null where it has not.
  std::exception_ptr TakeFailure();

 private:
  void Begin(int64_t number, float* observation);
  void Decide(const float* action, const Results& results);
  void WriteObservation(float* out) const;

  runtime::DecisionProcess process_;
  size_t index_;
  Common common_;
  Eigen::VectorXd action_;
  bool has_record_ = false;
  bool has_ended_ = false;
  std::exception_ptr failure_;
};

}  // namespace libtaskc_sim
