#include "runtime/trainer/results/decision_recorder.h"

#include <utility>

namespace runtime {

DecisionRecorder::DecisionRecorder(const Environment& environment, Module& learner,
                                   const std::vector<Port*>& results)
    : Module("recorder"),
      environment_(environment),
      learners_in_(learner.FindPort("observation")),
      learners_source_(*learners_in_.Connections().front()) {
  Port::Disconnect(learners_source_, learners_in_);
  Port::Connect(learners_source_, source_);
  Port::Connect(observation_, learners_in_);
  for (Port* result : results) {
    results_.push_back(std::make_unique<In<Eigen::VectorXd>>(this, result->name()));
    Port::Connect(*result, *results_.back());
  }
  Port::Connect(learner.FindPort("execute"), execute_);
  Port::Connect(environment.FindPort("start_of_time_step"), start_of_time_step_);
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
  pending_ = {environment_.time()};
  for (const Eigen::VectorXd* part : {&std::as_const(seen_), &action})
    pending_.insert(pending_.end(), part->begin(), part->end());
}

// The action space has begun the time step before: it was connected before.
void DecisionRecorder::NoteResults(double) {
  if (pending_.empty()) return;
  for (const auto& result : results_)
    pending_.insert(pending_.end(), (*result)().begin(), (*result)().end());
  decisions_.push_back(std::exchange(pending_, {}));
}

}  // namespace runtime
