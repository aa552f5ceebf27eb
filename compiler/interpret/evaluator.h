// Runs a checked task without building it. What plugins compute is held against this: every value
// has the same bits, since each operation is the same, in the same order. It is written to be
// obviously right, not to be fast.
#pragma once

#include <optional>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/check/value.h"
#include "compiler/interpret/blame.h"
#include "compiler/interpret/frame.h"
#include "compiler/interpret/random_numbers.h"

namespace compiler {

class Evaluator {
 public:
  // Refers to the task, which must outlive it. Memory has its initial values.
  explicit Evaluator(const CheckedTask& task);

  // A host's part of the frame may be set between calls.
  Frame& frame() { return frame_; }
  const Frame& frame() const { return frame_; }

  // Gives all memory its initial value, then draws the goals.
  void Initialize();
  // Draws in which pose an episode starts, and what the start makes of that: it changes the memory
  // of CheckedStart::values, and leaves all else as it is when an episode starts.
  void DrawPose();
  void DrawStart();
  // Runs what the task does at an event of this kind.
  void Fire(EventKind kind, double time_step);
  // From now on, where this term is not paid because it is not finite or too large, Fire() notes
  // where that comes from: of the first such reward.
  void Watch(uint32_t term) { watched_ = term; }
  const std::optional<Blame>& blame() const { return blame_; }
  // Computes all metrics.
  void Measure();
  // Computes what the learner sees.
  void Observe();

  // The value of an expression that reads no locals: of a test's `expect`, of a metric.
  Value Evaluate(const CheckedExpression& expression) const;

 private:
  void Reset(uint32_t memory);
  void Run(const CheckedBlock& block);
  void Run(const CheckedLet& let);
  void Run(const CheckedAssign& assign);
  void Run(const CheckedIf& branches);
  void Run(const CheckedFor& loop);
  void Run(const CheckedReward& reward);
  void Run(const CheckedEnd& end);
  void Run(const CheckedLog& log);
  void Run(const CheckedRequire& require);
  void Run(const CheckedRedraw& redraw);
  void Run(const CheckedNext& next);
  void Run(const CheckedPhaseSwitch& phases);
  void Run(const CheckedAdvance& advance);
  void Run(const CheckedPotentialStep& step);
  // `expression`: whose value it is.
  void Pay(uint32_t term, double value, const CheckedExpression& expression);
  Value EvaluateHere(const CheckedExpression& expression) const;

  const CheckedTask& task_;
  Frame frame_;
  std::vector<Value> locals_;  // of the event that runs
  LetValues lets_;             // of these locals
  std::optional<uint32_t> watched_;
  std::optional<Blame> blame_;
  int32_t next_phase_ = -1;  // what a phase that runs has said; -1: nothing
  DrawPlace place_;          // of a start that is drawn
};

}  // namespace compiler
