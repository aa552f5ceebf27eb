#include "runtime/training/learning/joint_offsets.h"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include "runtime/training/learning/dof_configuration.h"
#include "runtime/training/learning/robot_sensor_in.h"

namespace runtime {

JointOffsets::JointOffsets(std::string name, const Context& context)
    : Module(std::move(name)), robot_(RobotOf(context, this->name())) {
  AddParameter({.name = "dof",
                .doc = "what the elements of an action move: a DoF configuration of the robot, or "
                       "\"all\" joints",
                .target = &dof_,
                .is_live = false});
  AddParameter({.name = "hold",
                .doc = "time steps that an action lasts",
                .target = &hold_,
                .minimum = 1,
                .maximum = std::numeric_limits<int>::max()});
  AddParameter({.name = "scale",
                .doc = "how far an action of 1 moves a target",
                .target = &scale_,
                .minimum = 0,
                .unit = "rad"});
  for (size_t i = 0; i < robot_.joints.size(); ++i) {
    const bool has_motor = robot_.GainsOf(robot_.joints[i]).HasMotor();
    if (has_motor && !robot_.joints[i].HasStops()) wheels_.push_back(static_cast<int>(i));
  }
  if (wheels_.empty()) return;
  joint_angle_.reset(new SensorIn(MakeSensorIn(this, robot::SensorId::kJointAngle)));
}

const int& JointOffsets::ActionSize() {
  if (action_size_ == 0) Prepare();
  return action_size_;
}

void JointOffsets::Prepare() {
  const auto joints = static_cast<Eigen::Index>(robot_.joints.size());
  const robot::DofConfiguration dof = FindDofOrJoints(robot_, dof_, name() + ".dof");
  mapping_ = DofMapping(dof, static_cast<int>(joints));
  rest_ = Eigen::Map<const Eigen::VectorXd>(robot_.poses.front().joint_angles.data(), joints);
  stops_ = JointStops(robot_);
  offsets_.setZero(joints);
  targets_ = rest_;
  moved_joints_ = dof.representatives;
  action_size_ = dof.dof();
}

void JointOffsets::Execute(const Eigen::VectorXd& action) {
  if (action.size() != action_size_) {
    throw UserError(fmt::format(
        "`{}` gets an action of {} elements, and its actions have {}: take their size from it",
        name(), action.size(), action_size_));
  }
  mapping_.Apply(action, offsets_);
  offsets_ *= scale_;
  if (!motion_.connected()) OffsetFrom(rest_);
  steps_left_ = hold_;
}

void JointOffsets::OffsetFrom(const Eigen::VectorXd& pose) {
  targets_ = pose + offsets_;
  stops_.Limit(targets_);
  OffsetWheels();
}

void JointOffsets::OffsetWheels() {
  if (!joint_angle_) return;
  const double* angles = (*joint_angle_)().reals();
  for (const int joint : wheels_) targets_[joint] = angles[joint] + offsets_[joint];
}

void JointOffsets::StartOfTimeStep(double) {
  if (motion_.connected()) OffsetFrom(motion_());
}

PolicyGraph::Value JointOffsets::AddTo(PolicyGraph& graph, PolicyGraph::Value action) const {
  if (!wheels_.empty()) {
    throw UserError(
        fmt::format("the policy cannot be exported: the target of `{}`, a joint without stops, "
                    "follows its angle in each time step",
                    robot_.joints[static_cast<size_t>(wheels_.front())].name));
  }
  std::vector<PolicyElement> elements;
  for (const int joint : moved_joints_) {
    elements.push_back({robot_.joints[static_cast<size_t>(joint)].name, ""});
  }
  graph.others.push_back({"action", action, std::move(elements)});
  graph.time_steps = hold_;
  const Eigen::VectorXd from = motion_.connected() ? Eigen::VectorXd::Zero(rest_.size()) : rest_;
  const PolicyGraph::Value targets = graph.Add(
      PolicyGraph::Affine{action, (scale_ * mapping_.factors()).cast<float>(), from.cast<float>()});
  if (motion_.connected()) {
    graph.motion = Motion().AsFunctionOfTime();
    return targets;
  }
  return graph.Add(
      PolicyGraph::Clamp{targets, stops_.low.cast<float>(), stops_.high.cast<float>()});
}

const MotionPart& JointOffsets::Motion() const {
  const Module& source = motion_.Connections().front()->owner();
  if (const auto* part = dynamic_cast<const MotionPart*>(&source)) return *part;
  throw UserError(
      fmt::format("the policy cannot be exported: `{}` is connected to `{}`, whose joint targets "
                  "are no function of time; those of a MotionGenerator are",
                  motion_.full_name(), source.name()));
}

void JointOffsets::EndOfTimeStep(double) {
  OffsetWheels();
  if (steps_left_ == 0 || --steps_left_ > 0) return;
  end_of_action_();  // usually starts the next action
}

}  // namespace runtime
