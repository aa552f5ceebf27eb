// What examples/tasks/follow.task and track_speed.task say in words: nobody has published them.
#include <cmath>
#include <numbers>

#include "tests/examples/published.h"

namespace examples {
namespace {

double Bell(double x, double width) { return std::exp(-(x / width) * (x / width)); }

bool TouchesWith(const RobotState& state, std::initializer_list<const char*> links) {
  for (const char* link : links)
    if (state.Touches(LinkOf(link))) return true;
  return false;
}

class Follow : public Published {
 public:
  // Some stand beside the leader.
  void Adapt(RobotState& state) const override {
    if (state.wish > 0.3) state.leader = state.position.head<2>() + 0.2 * state.leader;
  }

  void Start(const RobotState&) override { has_arrived_ = false; }

  Payments Step(const RobotState& state, const compiler::Instance&) override {
    const Eigen::Vector2d way = state.leader - state.position.head<2>();
    const Eigen::Vector3d forward = state.orientation * Eigen::Vector3d::UnitX();
    const double turn = std::remainder(
        std::atan2(way.y(), way.x()) - std::atan2(forward.y(), forward.x()), 2 * std::numbers::pi);
    Payments terms = {{"near", Bell(way.norm(), 0.4) * kTimeStep},
                      {"facing", 0.5 * Bell(turn, std::numbers::pi / 4) * kTimeStep}};
    if (way.norm() < 0.2 && !has_arrived_) {
      has_arrived_ = true;
      terms["arrival"] = state.time < 5 ? 2 : 1;
    }
    if (TouchesWith(state, {"body", "head"})) terms["fall"] = -4;
    return terms;
  }

 private:
  bool has_arrived_ = false;
};

class TrackSpeed : public Published {
 public:
  void StartAction() override { has_stumbled_ = false; }

  Payments Step(const RobotState& state, const compiler::Instance&) override {
    Payments terms = {{"tracking", Bell(state.wish - state.velocity.x(), 0.2) * kTimeStep}};
    bool stumbles = false;
    for (const robot::Link& link : Humanoid().links)
      stumbles = stumbles || (!link.name.ends_with("foot") && state.Touches(LinkOf(link.name)));
    if (stumbles && !has_stumbled_) {
      has_stumbled_ = true;
      terms["stumble"] = TouchesWith(state, {"left_hand", "right_hand"}) ? -1 : -0.5;
    }
    if (TouchesWith(state, {"body", "head"})) terms["fall"] = -4;
    return terms;
  }

 private:
  bool has_stumbled_ = false;
};

}  // namespace

std::unique_ptr<Published> OwnFollow() { return std::make_unique<Follow>(); }
std::unique_ptr<Published> OwnTrackSpeed() { return std::make_unique<TrackSpeed>(); }

}  // namespace examples
