// A robot's symmetry, found in its description: what becomes of each joint when left and right are
// exchanged, that is, when the robot in its zero pose is mirrored at the plane y = 0.
#pragma once

#include <vector>

#include "plugins/robot/robot_description.h"

namespace runtime {

struct MirroredJoint {
  int joint = -1;   // what the joint becomes; -1: the robot has no such joint
  double sign = 1;  // of its angle there, 1 or -1
};

// One for each joint. A joint in the middle may become itself. Anchors that are less than a
// millimeter apart count as the same.
std::vector<MirroredJoint> MirrorJoints(const robot::RobotDescription& robot);

// What the joints of a DoF configuration do, done by their mirror images. Throws UserError, which
// begins with the parameter's name, where a joint has none, or has one that the configuration
// moves.
robot::DofConfiguration MirrorDof(const robot::RobotDescription& robot,
                                  const robot::DofConfiguration& dof, const std::string& parameter);

// The joints that have a mirror image other than themselves, of each pair the first.
std::vector<int> OneSide(const robot::RobotDescription& robot);

}  // namespace runtime
