#pragma once

#include <memory>
#include <string>
#include <vector>

#include "runtime/core/module/context.h"
#include "runtime/core/module/module.h"
#include "runtime/core/module/sensor_data.h"
#include "runtime/core/module/values.h"
#include "runtime/training/learning/dof_mapping.h"
#include "runtime/training/learning/joint_stops.h"
#include "runtime/training/learning/policy_graph.h"

namespace runtime {

// An action space whose actions are vectors: how far the joints' targets are from the robot's rest
// pose, its first one, or from a motion. Each element moves a coordinate of a DoF configuration, or
// a joint, by `scale` [rad]; targets go no farther than the joints' stops. The offsets are held for
// `hold` time steps; then the action is over.
//
// A joint without stops, as that of a wheel, is moved from where it is in each time step: an offset
// that is held turns it at stiffness / damping * offset.
//
//   in   motion: the joints' targets that the offsets are from, in each time step; unconnected: the
//        rest pose
//   out  joint_targets
//        joint_offsets: how far they are meant to be from there, whatever the stops [rad]
class JointOffsets : public Module, public PolicyPart {
 public:
  JointOffsets(std::string name, const Context& context);

  void Start() override { ActionSize(); }

  // Throws UserError also where the offsets are from the targets of a module that is no MotionPart.
  PolicyGraph::Value AddTo(PolicyGraph& graph, PolicyGraph::Value action) const override;

 private:
  void Execute(const Eigen::VectorXd& action);
  void StartOfTimeStep(double time_step);
  void EndOfTimeStep(double time_step);
  const int& ActionSize();

  void OffsetFrom(const Eigen::VectorXd& pose);
  void OffsetWheels();
  const MotionPart& Motion() const;

  // When the action's size is first asked for: modules may be started in any order.
  void Prepare();

  const robot::RobotDescription& robot_;
  std::string dof_ = "all";
  int hold_ = 8;
  double scale_ = 1;

  int action_size_ = 0;
  std::vector<int> moved_joints_;  // for each element of an action the joint that stands for it
  DofMapping mapping_;
  Eigen::VectorXd rest_;
  JointStops stops_;
  Eigen::VectorXd offsets_;
  Eigen::VectorXd targets_;
  int steps_left_ = 0;

  std::vector<int> wheels_;                // joints without stops
  std::unique_ptr<SensorIn> joint_angle_;  // where the robot has any

  In<Eigen::VectorXd> motion_{this, "motion", "", In<Eigen::VectorXd>::Need::kOptional};
  Out<Eigen::VectorXd> joint_targets_{this, "joint_targets", &targets_};
  Out<Eigen::VectorXd> joint_offsets_{this, "joint_offsets", &offsets_};
  Out<int> action_size_out_{this, "action_size", Bind<&JointOffsets::ActionSize>{}};
  Slot<const Eigen::VectorXd&> execute_{this, "execute", Bind<&JointOffsets::Execute>{}};
  Slot<double> start_of_time_step_{this, "start_of_time_step",
                                   Bind<&JointOffsets::StartOfTimeStep>{}};
  Slot<double> end_of_time_step_{this, "end_of_time_step", Bind<&JointOffsets::EndOfTimeStep>{}};
  Signal<> end_of_action_{this, "end_of_action"};
};

}  // namespace runtime
