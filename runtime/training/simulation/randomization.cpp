#include "runtime/training/simulation/randomization.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "runtime/base/user_error.h"
#include "runtime/core/module/episode_seed.h"

namespace runtime {
namespace {

// What random numbers are for; sensors count from 0.
enum Purpose : uint64_t {
  kFriction = 1000,
  kMass,
  kGain,
  kDelay,
  kPushTime,
  kPushDirection,
  kPushSpeed
};

uint64_t Add(uint64_t key, uint64_t number) { return SplitMix(key + kSplitMixStep * (number + 1)); }

void CheckIsRange(const std::vector<double>& range, const std::string& name) {
  if (range.empty()) return;
  if (range.size() == 2 && range[0] <= range[1]) return;
  throw UserError(
      fmt::format("`{}` is no range: write [lowest, highest], or [] to leave it alone", name));
}

}  // namespace

EpisodeRandom::EpisodeRandom(uint64_t seed, int64_t episode)
    : key_(Add(Add(0, seed), static_cast<uint64_t>(episode))) {}

double EpisodeRandom::Uniform(uint64_t what, uint64_t index) const {
  constexpr double kStep = 1.0 / (uint64_t{1} << 53);
  return static_cast<double>(Add(Add(key_, what), index) >> 11) * kStep;
}

double EpisodeRandom::Between(const std::vector<double>& range, uint64_t what,
                              uint64_t index) const {
  return range[0] + (range[1] - range[0]) * Uniform(what, index);
}

// By the method of Box and Muller.
double EpisodeRandom::Normal(uint64_t what, uint64_t index) const {
  const double radius = std::sqrt(-2 * std::log(1 - Uniform(what, 2 * index)));
  return radius * std::cos(2 * std::numbers::pi * Uniform(what, 2 * index + 1));
}

std::vector<Parameter> Randomization::Parameters() {
  const auto range = [](const char* name, const char* doc, std::vector<double>& target,
                        double minimum, double maximum, const char* unit) {
    return Parameter{
        .name = name,
        .doc = std::string(doc) + ", [lowest, highest], drawn for each episode; []: not",
        .target = &target,
        .minimum = minimum,
        .maximum = maximum,
        .unit = unit};
  };
  const auto amount = [](const char* name, const char* doc, double& target, double maximum,
                         const char* unit) {
    return Parameter{.name = name,
                     .doc = doc,
                     .target = &target,
                     .minimum = 0,
                     .maximum = maximum,
                     .unit = unit,
                     .is_live = false};
  };
  return {
      range("random_friction", "coefficient of the ground's friction", friction_, 0, 10, ""),
      range("random_mass", "what the robot's masses and inertias are multiplied by", mass_, 0.1, 10,
            ""),
      range("random_gain", "what the controller's gains are multiplied by", gain_, 0.1, 10, ""),
      range("random_delay", "how much later the controller gets its targets", delay_, 0, 1, "s"),
      amount("push_speed", "the most that a push adds to the robot's velocity; 0: no pushes",
             push_speed_, 10, "m/s"),
      Parameter{.name = "push_interval",
                .doc = "from one push to the next, [shortest, longest]",
                .target = &push_interval_,
                .minimum = 0.05,
                .maximum = 1000,
                .unit = "s",
                .is_live = false},
      amount("angle_noise", "standard deviation of what is added to joint.angle", noise_.angle, 1,
             "rad"),
      amount("rate_noise",
             "standard deviation of what is added to joint.velocity and base.angular_velocity",
             noise_.rate, 100, "rad/s"),
      amount("velocity_noise", "standard deviation of what is added to base.velocity",
             noise_.velocity, 10, "m/s"),
  };
}

void Randomization::Check(const std::string& module) const {
  CheckIsRange(friction_, module + ".random_friction");
  CheckIsRange(mass_, module + ".random_mass");
  CheckIsRange(gain_, module + ".random_gain");
  CheckIsRange(delay_, module + ".random_delay");
  CheckIsRange(push_interval_, module + ".push_interval");
  if (has_pushes() && push_interval_.empty())
    throw UserError(
        fmt::format("`{0}.push_speed` wants pushes, and `{0}.push_interval` says not "
                    "when: write [shortest, longest] in seconds",
                    module));
}

bool Randomization::IsOff() const {
  return friction_.empty() && mass_.empty() && gain_.empty() && delay_.empty() && !has_pushes();
}

Randomization::Draw Randomization::DrawFor(const EpisodeRandom& random) const {
  Draw draw;
  if (!friction_.empty()) draw.friction = random.Between(friction_, kFriction);
  if (!mass_.empty()) draw.mass = random.Between(mass_, kMass);
  if (!gain_.empty()) draw.gain = random.Between(gain_, kGain);
  if (!delay_.empty()) draw.delay = random.Between(delay_, kDelay);
  return draw;
}

std::vector<DrawnValue> Randomization::Show(const Draw& draw) const {
  std::vector<DrawnValue> shown;
  if (!friction_.empty())
    shown.push_back({"friction", "", "coefficient of the ground's friction", draw.friction});
  if (!mass_.empty())
    shown.push_back({"mass", "", "what the robot's masses were multiplied by", draw.mass});
  if (!gain_.empty())
    shown.push_back({"gain", "", "what the controller's gains were multiplied by", draw.gain});
  if (!delay_.empty())
    shown.push_back({"delay", "s", "how much later the controller got its targets", draw.delay});
  return shown;
}

robot::RobotDescription Randomization::Change(const robot::RobotDescription& robot,
                                              const Draw& draw) const {
  robot::RobotDescription changed = robot;
  for (robot::Link& link : changed.links) {
    link.mass *= draw.mass;
    if (!link.inertia) continue;
    for (double* moment : {&link.inertia->xx, &link.inertia->yy, &link.inertia->zz,
                           &link.inertia->xy, &link.inertia->xz, &link.inertia->yz})
      *moment *= draw.mass;
  }
  changed.controller.stiffness *= draw.gain;
  changed.controller.damping *= draw.gain;
  for (robot::Joint& joint : changed.joints) {
    if (joint.gains.stiffness) *joint.gains.stiffness *= draw.gain;
    if (joint.gains.damping) *joint.gains.damping *= draw.gain;
  }
  return changed;
}

world::WorldDescription Randomization::Change(const world::WorldDescription* world,
                                              const Draw& draw) const {
  world::WorldDescription changed = world == nullptr ? world::WorldDescription{} : *world;
  if (!friction_.empty()) changed.ground.friction = draw.friction;
  return changed;
}

double Randomization::PushAfter(const EpisodeRandom& random, uint64_t index) const {
  return random.Between(push_interval_, kPushTime, index);
}

std::array<double, 2> Randomization::PushOf(const EpisodeRandom& random, uint64_t index) const {
  const double direction = 2 * std::numbers::pi * random.Uniform(kPushDirection, index);
  const double speed = push_speed_ * random.Uniform(kPushSpeed, index);
  return {speed * std::cos(direction), speed * std::sin(direction)};
}

}  // namespace runtime
