// A robot's description as MuJoCo reads it: a text in MJCF.
#pragma once

#include <memory>
#include <string>

#include "plugins/robot/robot_description.h"
#include "runtime/training/simulation/mujoco_library.h"
#include "runtime/training/simulation/physics_solver.h"

namespace runtime {

// Bodies, joints and shapes have the names of the links, joints and links that they are; the ground
// is a plane. Each body's frame is its link's
// (runtime/training/simulation/link_frames.h). A hinge's coordinate is the joint's angle, a
// slider's is radius * angle. A fixed base is a mocap body. Motors, springs and dampers are not in
// it: MujocoSolver has them.
std::string Mjcf(const robot::RobotDescription& robot, const SolverSettings& settings,
                 const RobotBody& body);

// MuJoCo's model of such a text, which all who use it at the same time share, in any thread. Throws
// UserError with MuJoCo's message if it is none.
std::shared_ptr<const mjModel> CompiledModel(const std::string& mjcf);

}  // namespace runtime
