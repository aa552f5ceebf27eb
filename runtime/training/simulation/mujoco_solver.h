// A physics step by MuJoCo (2.2.2): other equations than ODE's, solved by other methods.
#pragma once

#include <memory>

#include "runtime/training/simulation/physics_solver.h"

namespace runtime {

// `around` and `body` outlive the solver. Throws UserError where MuJoCo cannot simulate the robot,
// and in a build without MuJoCo.
std::unique_ptr<PhysicsSolver> MakeMujocoSolver(const robot::RobotDescription& robot,
                                                const Surroundings& around,
                                                const SolverSettings& settings,
                                                const JointController& controller, RobotBody& body);

// Whether this program was built with MuJoCo.
bool HasMujoco();

}  // namespace runtime
