#pragma once

#include <vector>

#include "runtime/core/module/module_graph.h"
#include "runtime/core/module/values.h"
#include "runtime/training/environment/environment.h"

namespace runtime {

// Listens to what a policy sees and does: it stands between the learner's in port `observation` and
// what that read before, and hears of each action after the action space has.
class DecisionRecorder : public Module {
 public:
  // Connects itself. `joint_targets`: out port of the action space. All outlive this object.
  DecisionRecorder(const Environment& environment, Module& learner, Port& joint_targets);
  ~DecisionRecorder() override;  // connects the learner as it was before

  // For each decision: the time in the episode [s], the observation that it was made for, the
  // action, the joints' targets.
  const std::vector<std::vector<double>>& decisions() const { return decisions_; }

 private:
  const Eigen::VectorXd& Observe();
  void Note(const Eigen::VectorXd& action);

  const Environment& environment_;
  Port& learners_in_;
  Port& learners_source_;
  Eigen::VectorXd seen_;  // last
  std::vector<std::vector<double>> decisions_;
  In<Eigen::VectorXd> source_{this, "source"};
  In<Eigen::VectorXd> joint_targets_{this, "joint_targets"};
  Out<Eigen::VectorXd> observation_{this, "observation", Bind<&DecisionRecorder::Observe>{}};
  Slot<const Eigen::VectorXd&> execute_{this, "execute", Bind<&DecisionRecorder::Note>{}};
};

}  // namespace runtime
