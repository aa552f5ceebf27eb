#pragma once

#include <string>

#include "runtime/core/module/context.h"
#include "runtime/core/module/module.h"
#include "runtime/training/learning/state.h"
#include "tests/runtime/training/learning/test_robot.h"

namespace runtime {

// A state that is what the test says.
class FakeState : public Module, public State {
 public:
  explicit FakeState(const std::string& dof)
      : Module("state"),
        values(Eigen::VectorXd::Zero(Size(Humanoid().FindDof(dof)->dof()))),
        dof_(*Humanoid().FindDof(dof)) {}

  const robot::DofConfiguration& dof() const override { return dof_; }
  const Eigen::VectorXd& Read() const override { return values; }

  auto angles() { return values.segment(kAngles, dof_.dof()); }

  Eigen::VectorXd values;

 private:
  const robot::DofConfiguration& dof_;
  Out<State> state_{this, "state", this};
};

inline Context HumanoidContext() { return {.robot = &Humanoid(), .task = {}, .seed = 1}; }

// Connects the ports of these names.
inline void Connect(Module& from, const char* out, Module& to, const char* in) {
  Port::Connect(from.FindPort(out), to.FindPort(in));
}

}  // namespace runtime
