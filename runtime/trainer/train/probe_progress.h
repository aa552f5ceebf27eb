#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/live/workers/supervisor.h"
#include "runtime/trainer/train/probe_search.h"
#include "runtime/training/run/live_text.h"

namespace runtime {

// Shows how far a probe is, in one line that stays up to date on a terminal; elsewhere such a line
// now and then.
//
//   4 searches  312 episodes  best 401.7  0:41 left
class ProbeProgress : public SupervisorListener {
 public:
  ProbeProgress(ProgressStyle style, const ProbeBudget& budget);

  // `runs` are those of the supervisor that is about to run.
  void Follow(const std::vector<RunProgress>& runs);
  void Erase() { live_.Erase(); }

  void OnStart() override { Refresh(); }
  void OnLine(const RunProgress&, std::string_view) override { Refresh(); }
  void OnMessage(const RunProgress& run, std::string_view text) override;
  void OnStopping(bool at_once) override;

 private:
  void Refresh();
  std::string Line() const;
  // Of the budget; less than 0 while it is not known.
  double SecondsLeft() const;

  const ProgressStyle style_;
  const ProbeBudget budget_;
  const std::chrono::steady_clock::time_point start_;
  LiveText live_;
  const std::vector<RunProgress>* runs_ = nullptr;
  int64_t episodes_before_ = -1;  // of this call
  std::chrono::steady_clock::time_point last_ = {};
};

}  // namespace runtime
