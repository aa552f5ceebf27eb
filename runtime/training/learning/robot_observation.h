// What a learner sees of a robot whose task says nothing about it: what a task sees that says
//
//   observe height = base.position.z
//   observe up = rotate(inverse(base.orientation), vec3(0, 0, 1))
//   observe velocity = rotate(inverse(base.orientation), base.velocity)
//   observe angular_velocity = rotate(inverse(base.orientation), base.angular_velocity)
//   observe joint.angle - joint.rest
//   observe joint.velocity
//   observe joint.target - joint.rest
//   observe contact
//
// So nothing in it tells where the robot is or in which direction it looks, and the targets are
// those of the last action.
#pragma once

#include <Eigen/Core>
#include <string>

#include "plugins/robot/robot_description.h"
#include "plugins/robot/sensors.h"
#include "runtime/core/module/module.h"
#include "runtime/core/module/observations.h"
#include "runtime/core/module/sensor_data.h"

namespace runtime {

class RobotObservation {
 public:
  // Adds an in port to `owner` for each sensor that it reads, of the sensor's name. None of them
  // has to be connected, unless Compute() is called. `robot` and `owner` outlive this object.
  RobotObservation(Module* owner, const robot::RobotDescription& robot);

  ObservationLayout layout() const;
  // Throws UserError where a sensor has no connection.
  void RequireSensors() const;
  // The numbers as of now. Precondition: RequireSensors() did not throw, an episode runs, and
  // `values` has as many elements as the layout.
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
