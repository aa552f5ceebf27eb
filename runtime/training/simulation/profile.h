// How a robot is simulated: the choice between faithful and fast. docs/simulation.md has the
// measurements behind the figures.
#pragma once

#include <array>
#include <string_view>

namespace runtime {

enum class JointDrive {
  kTorque,  // the PD law gives a torque, constant during a physics step; as in the paper
  kMotor,   // a motor that is stepped implicitly as a saturated spring and damper
};

enum class SolverKind {
  kOde,     // ODE's dWorldStep
  kTree,    // the same equations along the tree of the links
            // (runtime/training/simulation/tree_solver.h)
  kMujoco,  // other equations: those of MuJoCo (runtime/training/simulation/mujoco_solver.h)
};

// The two numbers that make a constraint of ODE act as a spring and a damper.
struct Softness {
  double erp;
  double cfm;
};

struct Profile {
  std::string_view name;
  double longest_time_step;  // [s]
  JointDrive drive;
  double contact_damping;  // [N s / m]; MuJoCo has its own
  SolverKind solver;

  // Physics steps in one time step: the fewest that are no longer than allowed.
  int PhysicsStepsPerTimeStep(double time_step) const;

  // Whether this program was built with what the profile needs.
  bool IsBuilt() const;

  // All profiles of ODE's equations have contacts of the same stiffness.
  Softness ContactSoftness(double time_step) const;
};

inline constexpr std::array<Profile, 5> kProfiles = {{
    // Contacts of ERP 0.2 and CFM 0.001.
    {"paper", 0.0002, JointDrive::kTorque, 800, SolverKind::kOde},
    // With this damping the robot touches the ground as often as in the paper's profile.
    {"fast", 0.005 / 3, JointDrive::kMotor, 1500, SolverKind::kOde},
    // The same two, solved faster; their motions differ from those above by rounding only.
    {"paper-tree", 0.0002, JointDrive::kTorque, 800, SolverKind::kTree},
    {"fast-tree", 0.005 / 3, JointDrive::kMotor, 1500, SolverKind::kTree},
    // A second opinion: another engine's equations, contacts and collisions.
    {"mujoco", 0.0025, JointDrive::kMotor, 1500, SolverKind::kMujoco},
}};

// Precondition: `name` is that of a profile.
const Profile& FindProfile(std::string_view name);

}  // namespace runtime
