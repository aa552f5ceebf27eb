// A robot and what is around it as MuJoCo reads them: a text in MJCF.
#pragma once

#include <compare>
#include <memory>
#include <string>

#include "plugins/robot/robot_description.h"
#include "runtime/training/simulation/mujoco_library.h"
#include "runtime/training/simulation/physics_solver.h"

namespace runtime {

struct Mjcf {
  std::string text;
  std::string hills;  // the bytes of the file with their heights that the text names, or nothing

  auto operator<=>(const Mjcf&) const = default;
};

// Bodies, joints and shapes have the names of the links, joints and links that they are. Each
// body's frame is its link's (runtime/training/simulation/link_frames.h). A hinge's coordinate is
// the joint's angle, a slider's is radius * angle. A fixed base is a mocap body. Motors, springs
// and dampers are not in it: MujocoSolver has them. What else there is: mjcf_surroundings.h.
Mjcf MjcfOf(const robot::RobotDescription& robot, const Surroundings& around,
            const SolverSettings& settings, const RobotBody& body);

// MuJoCo's model of it, which all who use it at the same time share, in any thread. Throws
// UserError with MuJoCo's message if it is none.
std::shared_ptr<const mjModel> CompiledModel(const Mjcf& mjcf);

}  // namespace runtime
