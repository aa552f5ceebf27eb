#include "runtime/training/learning/ng_net.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "runtime/base/suggestion.h"
#include "runtime/core/module/connections.h"
#include "runtime/training/learning/bubble_net.h"
#include "runtime/training/learning/grid_net.h"
#include "runtime/training/learning/kept_spheres.h"

namespace runtime {
namespace {

// A net over the angles of some joints serves every configuration with these representatives.
bool Fits(const robot::DofConfiguration& net, const robot::DofConfiguration& state) {
  return net.representatives == state.representatives;
}

GaussianNet MakeNet(const robot::NetDescription& net, int seed, Norm norm) {
  switch (net.kind) {
    case robot::NetKind::kGrid:
      return GridNet(net, norm);
    case robot::NetKind::kBubble:
      return BubbleNet(KeptSpheres(net, static_cast<uint64_t>(seed)), norm);
  }
  return {};
}

}  // namespace

NgNet::NgNet(std::string name, const Context& context)
    : Module(std::move(name)), robot_(RobotOf(context, this->name())) {
  AddParameter({.name = "net",
                .doc = "Gaussian network of the robot",
                .target = &net_name_,
                .is_live = false});
  AddParameter({.name = "net_seed",
                .doc = "for bubble nets: another number gives other, equally good centers",
                .target = &net_seed_,
                .minimum = 0,
                .is_live = false});
  AddParameter({.name = "max_norm",
                .doc = "measure distances between centers by the max norm",
                .target = &max_norm_,
                .is_live = false});
}

void NgNet::Start() { Net(); }

const GaussianNet& NgNet::Net() {
  if (net_.units() == 0) {
    RequireConnections(*this);
    const robot::NetDescription& description = FindNet();
    RequireFit(description);
    net_ = MakeNet(description, net_seed_, NormFrom(max_norm_));
    features_.setZero(net_.units());
  }
  return net_;
}

const Eigen::VectorXd& NgNet::Features() {
  net_.Evaluate(state_in_().Read().segment(State::kAngles, net_.dimensions()), features_);
  return features_;
}

const robot::NetDescription& NgNet::FindNet() const {
  if (const robot::NetDescription* found = robot_.FindNet(net_name_)) return *found;
  std::vector<std::string> names;
  for (const robot::NetDescription& net : robot_.nets) names.push_back(net.name);
  throw UserError(fmt::format("`{}.net`: the robot `{}` has no net `{}`{}", name(), robot_.name,
                              net_name_, Suggestion(net_name_, names)));
}

void NgNet::RequireFit(const robot::NetDescription& net) const {
  const robot::DofConfiguration& dof = state_in_().dof();
  if (Fits(*robot_.FindDof(net.dof), dof)) return;
  std::string fitting;
  for (const robot::NetDescription& other : robot_.nets) {
    if (Fits(*robot_.FindDof(other.dof), dof)) fitting += fmt::format(" `{}`", other.name);
  }
  throw UserError(fmt::format(
      "`{}.net`: the net `{}` is made for the DoF configuration `{}`, but the state is that of "
      "`{}`; its nets:{}",
      name(), net.name, net.dof, dof.name, fitting.empty() ? " none" : fitting));
}

}  // namespace runtime
