#include "runtime/training/simulation/profile.h"

#include <cassert>
#include <cmath>

#include "runtime/training/simulation/mujoco_solver.h"

namespace runtime {

int Profile::PhysicsStepsPerTimeStep(double time_step) const {
  // A step may be longer by a rounding error.
  return static_cast<int>(std::ceil(time_step / longest_time_step * (1 - 1e-9)));
}

bool Profile::IsBuilt() const { return solver != SolverKind::kMujoco || HasMujoco(); }

Softness Profile::ContactSoftness(double time_step) const {
  constexpr double kStiffness = 1e6;  // N / m
  const double pull = time_step * kStiffness;
  return {.erp = pull / (pull + contact_damping), .cfm = 1 / (pull + contact_damping)};
}

const Profile& FindProfile(std::string_view name) {
  for (const Profile& profile : kProfiles) {
    if (profile.name == name) return profile;
  }
  assert(!"a profile's name");
  return kProfiles.front();
}

}  // namespace runtime
