#include "runtime/training/learning/robot_observation.h"

#include <Eigen/Geometry>
#include <vector>

#include "runtime/training/learning/robot_sensor_in.h"

namespace runtime {
namespace {

using Eigen::Map, Eigen::Vector3d, Eigen::VectorXd;

// w, x, y, z
Eigen::Quaterniond Quaternion(const double* elements) {
  return {elements[0], elements[1], elements[2], elements[3]};
}

}  // namespace

RobotObservation::RobotObservation(Module* owner, const robot::RobotDescription& robot)
    : robot_(robot),
      position_(MakeSensorIn(owner, robot::SensorId::kBasePosition)),
      orientation_(MakeSensorIn(owner, robot::SensorId::kBaseOrientation)),
      velocity_(MakeSensorIn(owner, robot::SensorId::kBaseVelocity)),
      angular_velocity_(MakeSensorIn(owner, robot::SensorId::kBaseAngularVelocity)),
      joint_angle_(MakeSensorIn(owner, robot::SensorId::kJointAngle)),
      joint_velocity_(MakeSensorIn(owner, robot::SensorId::kJointVelocity)),
      joint_target_(MakeSensorIn(owner, robot::SensorId::kJointTarget)),
      contact_(MakeSensorIn(owner, robot::SensorId::kContact)) {
  const std::vector<double>& rest = robot.poses.front().joint_angles;
  rest_ = Map<const VectorXd>(rest.data(), static_cast<Eigen::Index>(rest.size()));
}

Eigen::Index RobotObservation::size() const {
  return 10 + static_cast<Eigen::Index>(3 * robot_.joints.size() + robot_.links.size());
}

void RobotObservation::Compute(VectorXd& values) const {
  const auto joints = static_cast<Eigen::Index>(robot_.joints.size());
  const auto of_joints = [&](const SensorIn& sensor) {
    return Map<const VectorXd>(sensor().reals(), joints);
  };
  const Eigen::Matrix3d to_body = Quaternion(orientation_().reals()).toRotationMatrix().transpose();
  values[0] = position_().reals()[2];
  values.segment<3>(1) = to_body.col(2);
  values.segment<3>(4) = to_body * Map<const Vector3d>(velocity_().reals());
  values.segment<3>(7) = to_body * Map<const Vector3d>(angular_velocity_().reals());
  values.segment(10, joints) = of_joints(joint_angle_) - rest_;
  values.segment(10 + joints, joints) = of_joints(joint_velocity_);
  values.segment(10 + 2 * joints, joints) = of_joints(joint_target_) - rest_;
  const bool* touches = contact_().flags();
  for (Eigen::Index link = 0; link < values.size() - (10 + 3 * joints); ++link) {
    values[10 + 3 * joints + link] = touches[link] ? 1 : 0;
  }
}

}  // namespace runtime
