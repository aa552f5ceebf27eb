// Where the links of a tree are joined, and how far they have come apart. What is special in each
// kind of joint is in its class.
#pragma once

#include <memory>
#include <span>

#include "plugins/robot/robot_description.h"
#include "runtime/training/simulation/link_motion.h"
#include "runtime/training/simulation/tree_factor.h"

namespace runtime {

class JointGeometry {
 public:
  virtual ~JointGeometry() = default;

  // What the joint leaves free.
  virtual FreeMotion Free() const = 0;

  // Sets the arms and the axis of the joint. Returns the way and the small turn by which the child
  // would come to where it belongs.
  virtual Vector6 Read(const LinkState& parent, const LinkState& child, TreeJoint& joint) const = 0;

  // The rate of the joint's coordinate (runtime/training/simulation/body_joint.h), 0 where it has
  // none.
  virtual double Speed(const TreeJoint& joint, std::span<const Vector6> velocities) const;
  // Adds an impulse that increases the coordinate to the joint's load.
  virtual void AddImpulse(double impulse, TreeJoint& joint) const;
};

std::unique_ptr<JointGeometry> MakeGeometry(const robot::RobotDescription& robot,
                                            const robot::Branch& branch);

}  // namespace runtime
