#pragma once

#include <string>
#include <vector>

#include "runtime/training/learning/motion_module.h"
#include "runtime/training/learning/policy_graph.h"

namespace runtime {

// One motion, from the start of each episode to its end: what a policy can stand on, by its offsets
// from it (joint_offsets.h).
//
//   out  joint_targets: of the motion
//        phase: where in it the robot is, cos p and sin p; p grows by 2 pi in a period, or by pi
//        from the beginning of a motion that is done once to its end
class MotionGenerator : public MotionModule, public MotionPart {
 public:
  MotionGenerator(std::string name, const Context& context);

  // Throws UserError also where there are not as many parameters as such a motion has.
  void Start() override;

  PolicyMotion AsFunctionOfTime() const override { return motion().AsFunctionOfTime(); }

 private:
  void StartOfEpisode();
  void StartOfTimeStep(double time_step);
  void EndOfTimeStep(double time_step);
  void SetPhase(double time);

  std::vector<double> parameters_;
  Eigen::VectorXd taken_;  // the same
  Eigen::VectorXd phase_{{1, 0}};

  Slot<> start_of_episode_{this, "start_of_episode", Bind<&MotionGenerator::StartOfEpisode>{}};
  Slot<double> start_of_time_step_{this, "start_of_time_step",
                                   Bind<&MotionGenerator::StartOfTimeStep>{}};
  Slot<double> end_of_time_step_{this, "end_of_time_step", Bind<&MotionGenerator::EndOfTimeStep>{}};
  Out<Eigen::VectorXd> phase_out_{this, "phase", &phase_};
};

}  // namespace runtime
