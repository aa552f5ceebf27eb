#include "runtime/training/simulation/physics_solver.h"

#include <cassert>

#include "runtime/training/simulation/mujoco_solver.h"
#include "runtime/training/simulation/ode_solver.h"
#include "runtime/training/simulation/tree_solver.h"

namespace runtime {

std::unique_ptr<PhysicsSolver> MakeSolver(const robot::RobotDescription& robot,
                                          const Surroundings& around, const Profile& profile,
                                          const SolverSettings& settings,
                                          const JointController& controller, RobotBody& body,
                                          dWorldID world) {
  switch (profile.solver) {
    case SolverKind::kOde:
      return std::make_unique<OdeSolver>(robot, settings, controller, body, world);
    case SolverKind::kTree:
      return std::make_unique<TreeSolver>(robot, settings, controller, body);
    case SolverKind::kMujoco:
      return MakeMujocoSolver(robot, around, settings, controller, body);
  }
  assert(!"a solver");
  return nullptr;
}

}  // namespace runtime
