// What stands for the second engine in a build without MuJoCo.
#include "runtime/base/user_error.h"
#include "runtime/training/simulation/mujoco_solver.h"

namespace runtime {

bool HasMujoco() { return false; }

std::unique_ptr<PhysicsSolver> MakeMujocoSolver(const robot::RobotDescription&, const Surroundings&,
                                                const SolverSettings&, const JointController&,
                                                RobotBody&) {
  throw UserError(
      "this program was built without MuJoCo, which the profile `mujoco` stands for: install the "
      "package `libmujoco-dev`, and build again, or choose another profile");
}

}  // namespace runtime
