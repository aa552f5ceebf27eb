#include "runtime/training/run/tape_recorder.h"

#include <cmath>
#include <limits>
#include <span>

namespace runtime {

TapeRecorder::TapeRecorder(Environment& environment, const Learner& learner)
    : environment_(dynamic_cast<RobotEnvironment*>(&environment)),
      learner_(learner),
      most_steps_(static_cast<size_t>(std::lround(kMaximumDuration / environment.time_step()))) {
  if (environment_ == nullptr) return;
  commands_ = &static_cast<const In<Eigen::VectorXd>&>(environment_->FindPort("joint_targets"));
}

void TapeRecorder::StartEpisode(const std::optional<robot::StartState>& drawn) {
  is_whole_ = environment_ != nullptr;
  if (!is_whole_) return;
  actions_ = 0;
  tape_.start_pose = environment_->start_pose();
  tape_.start = drawn;
  tape_.targets.clear();
  tape_.actions.clear();
}

bool TapeRecorder::NoteTargets() {
  is_whole_ = commands_->connected();
  if (!is_whole_) return false;
  const std::span<const double> targets = environment_->told();
  if (tape_.targets.capacity() == 0) {
    tape_.joints = targets.size();
    tape_.targets.reserve(targets.size() * most_steps_);
    tape_.actions.reserve(most_steps_ + 1);
  }
  tape_.targets.insert(tape_.targets.end(), targets.begin(), targets.end());
  return true;
}

void TapeRecorder::Note(int64_t steps) {
  if (static_cast<size_t>(steps) > most_steps_) is_whole_ = false;
  if (!is_whole_) return;
  if (steps > 0 && !NoteTargets()) return;
  // Hardly more than one; an action space may have none that lasts for a time step.
  const int started = learner_.action_count() - actions_;
  if (started < 0 || started > std::numeric_limits<uint8_t>::max()) is_whole_ = false;
  tape_.actions.push_back(static_cast<uint8_t>(started));
  actions_ = learner_.action_count();
  tape_.discount = learner_.discount();
  tape_.ends_at_once = learner_.ends_at_once();
}

std::string TapeRecorder::Finish() const {
  const bool has_diverged = learner_.episode_end().kind == EndKind::kDiverged;
  return is_whole_ && tape_.steps() > 0 && !has_diverged ? Pack(tape_) : "";
}

}  // namespace runtime
