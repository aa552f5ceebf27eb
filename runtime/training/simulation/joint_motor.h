// What pulls along a joint.
#pragma once

namespace runtime {

// Pulls a joint toward a speed with a torque proportional to what is missing, within a limit.
//
// A spring and damper that are stepped implicitly are one. The torque at the end of a step of
// length h, where the angle has become q + h v, is
//   stiffness (target - q - h v) - damping v = stiffness (target - q) - (damping + h stiffness) v.
struct Motor {
  double speed = 0;       // [rad / s]
  double damping = 0;     // torque for each rad / s that is missing [N m s / rad]
  double max_torque = 0;  // [N m]
};

}  // namespace runtime
