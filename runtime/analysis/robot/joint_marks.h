// Where a robot's joints are, along what they move and how far, as lines over a picture.
#pragma once

#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/analysis/picture/strokes.h"
#include "runtime/training/simulation/link_frames.h"

namespace runtime {

// Of each joint: an arrow along its axis; around it the arc of its range, from a bar at the lower
// stop to an arrow head at the upper one; and a hand that shows where in it the joint is. Without
// stops the arc is a whole turn. Of a slider the arrow is its travel, with a bar at the lower end,
// and a bar across it shows where the joint is. What turns or shifts along x is red, along y green,
// along z blue, as in the robot's zero pose.
//
// `frames`: of the links. `size`: of the robot, to which that of the marks is fitted [m].
std::vector<Stroke> JointMarks(const robot::RobotDescription& robot,
                               const std::vector<LinkFrame>& frames, double size);

}  // namespace runtime
