// What a learner sees of a robot, whatever the task:
//
//   the height of its base [m]
//   in the base's own frame: the direction upward, velocity [m/s], angular velocity [rad/s]
//   of each joint: its angle and its target, from the robot's first pose on [rad], its rate [rad/s]
//   of each link: 1 where it touches something, else 0
//
// So nothing in it tells where the robot is or in which direction it looks, and the targets are
// those of the last action.
#pragma once

#include <Eigen/Core>

#include "plugins/robot/robot_description.h"
#include "plugins/robot/sensors.h"
#include "runtime/core/module/module.h"
#include "runtime/core/module/sensor_data.h"

namespace runtime {

class RobotObservation {
 public:
  // Adds an in port to `owner` for each sensor that it reads, of the sensor's name. `robot` and
  // `owner` outlive this object.
  RobotObservation(Module* owner, const robot::RobotDescription& robot);

  Eigen::Index size() const;
  // The numbers as of now. Precondition: all ports are connected, an episode runs, and `values` has
  // as many elements as size() says.
  void Compute(Eigen::VectorXd& values) const;

 private:
  const robot::RobotDescription& robot_;
  Eigen::VectorXd rest_;  // the angles in the robot's first pose
  SensorIn position_;
  SensorIn orientation_;
  SensorIn velocity_;
  SensorIn angular_velocity_;
  SensorIn joint_angle_;
  SensorIn joint_velocity_;
  SensorIn joint_target_;
  SensorIn contact_;
};

}  // namespace runtime
