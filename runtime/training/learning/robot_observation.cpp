#include "runtime/training/learning/robot_observation.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <vector>

#include "runtime/base/user_error.h"

namespace runtime {
namespace {

using Eigen::Map, Eigen::Vector3d, Eigen::VectorXd;

const robot::SensorDescription& Description(robot::SensorId id) {
  return robot::Sensors()[static_cast<size_t>(id)];
}

SensorIn MakeOptional(Module* owner, robot::SensorId id) {
  const robot::SensorDescription& sensor = Description(id);
  return SensorIn(owner, std::string(sensor.name), SensorTypeText(sensor.type, sensor.unit),
                  SensorIn::Need::kOptional);
}

// w, x, y, z
Eigen::Quaterniond Quaternion(const double* elements) {
  return {elements[0], elements[1], elements[2], elements[3]};
}

}  // namespace

RobotObservation::RobotObservation(Module* owner, const robot::RobotDescription& robot)
    : robot_(robot),
      position_(MakeOptional(owner, robot::SensorId::kBasePosition)),
      orientation_(MakeOptional(owner, robot::SensorId::kBaseOrientation)),
      velocity_(MakeOptional(owner, robot::SensorId::kBaseVelocity)),
      angular_velocity_(MakeOptional(owner, robot::SensorId::kBaseAngularVelocity)),
      joint_angle_(MakeOptional(owner, robot::SensorId::kJointAngle)),
      joint_velocity_(MakeOptional(owner, robot::SensorId::kJointVelocity)),
      joint_target_(MakeOptional(owner, robot::SensorId::kJointTarget)),
      contact_(MakeOptional(owner, robot::SensorId::kContact)) {
  const std::vector<double>& rest = robot.poses.front().joint_angles;
  rest_ = Map<const VectorXd>(rest.data(), static_cast<Eigen::Index>(rest.size()));
}

ObservationLayout RobotObservation::layout() const {
  const size_t joints = robot_.joints.size();
  return {
      {{.name = "height", .type = "real", .unit = "m"},
       {.name = "up", .type = "vec3", .unit = "", .size = 3, .minimum = -1, .maximum = 1},
       {.name = "velocity", .type = "vec3", .unit = "m/s", .size = 3},
       {.name = "angular_velocity", .type = "vec3", .unit = "rad/s", .size = 3},
       {.name = "joint.angle - joint.rest", .type = "real[joint]", .unit = "rad", .size = joints},
       {.name = "joint.velocity", .type = "real[joint]", .unit = "rad/s", .size = joints},
       {.name = "joint.target - joint.rest", .type = "real[joint]", .unit = "rad", .size = joints},
       {.name = "contact",
        .type = "bool[link]",
        .unit = "",
        .size = robot_.links.size(),
        .minimum = 0,
        .maximum = 1}}};
}

void RobotObservation::RequireSensors() const {
  for (const SensorIn* sensor : {&position_, &orientation_, &velocity_, &angular_velocity_,
                                 &joint_angle_, &joint_velocity_, &joint_target_, &contact_}) {
    if (sensor->connected()) continue;
    throw UserError(fmt::format(
        "`{0}` is not connected, and the task observes nothing, so that the learner is to see "
        "the robot's sensors: connect `ENVIRONMENT.*` to `{1}.*`",
        sensor->full_name(), sensor->owner().name()));
  }
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
