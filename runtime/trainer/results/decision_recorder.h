#pragma once

#include <memory>
#include <vector>

#include "runtime/core/module/module_graph.h"
#include "runtime/core/module/values.h"
#include "runtime/training/environment/environment.h"

namespace runtime {

// Listens to what a policy sees and does: it stands between the learner's in port `observation` and
// what that read before, and reads what the action space makes of each action when the robot begins
// to follow it.
class DecisionRecorder : public Module {
 public:
  // Connects itself. `results`: out ports of the action space. All outlive this object.
  DecisionRecorder(const Environment& environment, Module& learner,
                   const std::vector<Port*>& results);
  ~DecisionRecorder() override;  // connects the learner as it was before

  // For each decision: the time in the episode [s], the observation that it was made for, the
  // action, the results.
  const std::vector<std::vector<double>>& decisions() const { return decisions_; }

 private:
  const Eigen::VectorXd& Observe();
  void Note(const Eigen::VectorXd& action);
  void NoteResults(double time_step);

  const Environment& environment_;
  Port& learners_in_;
  Port& learners_source_;
  Eigen::VectorXd seen_;         // last
  std::vector<double> pending_;  // a decision that waits for its results
  std::vector<std::vector<double>> decisions_;
  In<Eigen::VectorXd> source_{this, "source"};
  std::vector<std::unique_ptr<In<Eigen::VectorXd>>> results_;
  Out<Eigen::VectorXd> observation_{this, "observation", Bind<&DecisionRecorder::Observe>{}};
  Slot<const Eigen::VectorXd&> execute_{this, "execute", Bind<&DecisionRecorder::Note>{}};
  Slot<double> start_of_time_step_{this, "start_of_time_step",
                                   Bind<&DecisionRecorder::NoteResults>{}};
};

}  // namespace runtime
