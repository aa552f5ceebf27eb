// What differs from episode to episode so that what is learned does not depend on it: friction,
// masses, gains, pushes, delays, and the noise of sensors.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "plugins/world/world_description.h"
#include "runtime/core/module/module.h"
#include "runtime/training/environment/environment.h"

namespace runtime {

// Random numbers that depend on the run's seed, the episode and what they are for alone: the same
// whatever was drawn before and in whichever thread.
class EpisodeRandom {
 public:
  EpisodeRandom(uint64_t seed, int64_t episode);

  // From 0 to less than 1. `what`: an enumerator, or the number of a sensor's element; `index`: of
  // those of it.
  double Uniform(uint64_t what, uint64_t index) const;
  double Between(const std::vector<double>& range, uint64_t what, uint64_t index = 0) const;
  double Normal(uint64_t what, uint64_t index) const;

 private:
  uint64_t key_;
};

// A list of two numbers is a range from which each episode draws; an empty one changes nothing.
class Randomization {
 public:
  // Those of the environment's module.
  std::vector<Parameter> Parameters();
  // Throws UserError, which calls the module `module`, where a range makes no sense.
  void Check(const std::string& module) const;
  bool IsOff() const;

  // What an episode is like. 1, and 0 of the delay, where nothing is randomized.
  struct Draw {
    double friction = robot::kUnlimited;  // coefficient of the ground
    double mass = 1;                      // factors
    double gain = 1;
    double delay = 0;  // of the targets [s]
  };
  Draw DrawFor(const EpisodeRandom& random) const;
  // The names and units of what is drawn, and the values, in one order: only of what is randomized.
  std::vector<DrawnValue> Show(const Draw& draw) const;

  // The robot and the world of an episode.
  robot::RobotDescription Change(const robot::RobotDescription& robot, const Draw& draw) const;
  world::WorldDescription Change(const world::WorldDescription* world, const Draw& draw) const;

  // Standard deviations of what is added to each element of some sensors whenever the world has
  // changed.
  struct Noise {
    double angle = 0;     // of joint.angle [rad]
    double rate = 0;      // of joint.velocity and base.angular_velocity [rad/s]
    double velocity = 0;  // of base.velocity [m/s]
  };
  const Noise& noise() const { return noise_; }

  bool has_pushes() const { return push_speed_ > 0; }
  // When push number `index` comes after the one before, or after the start [s].
  double PushAfter(const EpisodeRandom& random, uint64_t index) const;
  // What it adds to the velocity of all links: level, in any direction [m/s].
  std::array<double, 2> PushOf(const EpisodeRandom& random, uint64_t index) const;

 private:
  std::vector<double> friction_;
  std::vector<double> mass_;
  std::vector<double> gain_;
  std::vector<double> delay_;
  double push_speed_ = 0;  // [m/s]
  Noise noise_;
  std::vector<double> push_interval_ = {1, 4};
};

}  // namespace runtime
