#include "runtime/trainer/results/decision_recorder.h"

namespace runtime {

DecisionRecorder::DecisionRecorder(const Environment& environment, Module& learner,
                                   Port& joint_targets)
    : Module("recorder"),
      environment_(environment),
      learners_in_(learner.FindPort("observation")),
      learners_source_(*learners_in_.Connections().front()) {
  Port::Disconnect(learners_source_, learners_in_);
  Port::Connect(learners_source_, source_);
  Port::Connect(observation_, learners_in_);
  Port::Connect(joint_targets, joint_targets_);
  Port::Connect(learner.FindPort("execute"), execute_);
}

DecisionRecorder::~DecisionRecorder() {
  Port::Disconnect(observation_, learners_in_);
  Port::Connect(learners_source_, learners_in_);
}

const Eigen::VectorXd& DecisionRecorder::Observe() {
  seen_ = source_();
  return seen_;
}

void DecisionRecorder::Note(const Eigen::VectorXd& action) {
  std::vector<double>& decision = decisions_.emplace_back();
  decision.push_back(environment_.time());
  const Eigen::VectorXd* parts[] = {&seen_, &action, &joint_targets_()};
  for (const Eigen::VectorXd* part : parts)
    decision.insert(decision.end(), part->begin(), part->end());
}

}  // namespace runtime
