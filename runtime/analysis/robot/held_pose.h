// What becomes of a robot that is told to stay as it is: what a description or a profile gets wrong
// shows there, before anything learns.
#pragma once

#include <string>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/training/simulation/link_frames.h"
#include "runtime/training/simulation/profile.h"

namespace runtime {

// Two links that are within each other, or a link and the ground.
struct Overlap {
  int first = 0;     // link, or Contact::kGround
  int second = 0;    // link
  double depth = 0;  // [m]
};

// A pose after its joints were told to hold it for a while.
struct HeldPose {
  std::string pose;
  std::string profile;
  double size = 0;      // of the robot in this pose: the diameter of a sphere around it [m]
  double seconds = 0;   // for how long it was simulated
  std::string failure;  // why no longer: the simulation diverged; or empty

  std::vector<Overlap> overlaps;  // at the start; of each pair the deepest, the deepest first

  // From the start to the end. With a fixed base all are 0.
  double tilt = 0;   // how far the base's z axis has turned [rad]
  double drift = 0;  // of the base, along the ground [m]
  double sink = 0;   // of the base, down [m]

  // How much the speed of the joint that shakes most differs from a straight line within 50 ms: the
  // median over the second half, root mean square [rad/s].
  double chatter = 0;
  int chattering_joint = -1;  // -1 where there is no joint

  double real_time_factor = 0;   // simulated time for each second of one core
  std::vector<LinkFrame> start;  // of each link
  std::vector<LinkFrame> end;

  bool Stands() const;  // upright, and about as high as it was
};

// Holds the pose for `seconds`, in the simulation's time.
HeldPose HoldPose(const robot::RobotDescription& robot, const Profile& profile,
                  const robot::Pose& pose, double seconds = 1);

}  // namespace runtime
