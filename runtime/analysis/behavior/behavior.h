// What a robot did in an episode, in numbers that say nothing of when it did it: a gait is the same
// behavior whichever foot begins, and however long it is watched.
//
// Lengths and times are those of a robot as large as the humanoid of the paper that moves alike:
// lengths are divided by the robot's scale (robot_scale.h), times by its square root, as in
// Froude's law of similar motions under gravity.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/analysis/behavior/motion.h"

namespace runtime {

struct Behavior {
  // How the values of a height or tilt are spread: this many of them, ascending, each standing for
  // an equal share of the time.
  static constexpr int kQuantiles = 20;
  static constexpr int kPostures = 60;             // samples of the posture, equally apart in time
  static constexpr double kFloorDistance = 0.01;   // a link this close to the floor touches it [m]
  static constexpr double kLiftedDistance = 0.02;  // and is lifted only from this on [m]

  // ---- Base motion.
  Eigen::Vector2d velocity;  // mean, along and to the left of where the base faced at first [m/s]
  Eigen::Vector3d turns;     // full turns about the base's own x, y and z axis
  Eigen::VectorXd heights;   // of the base [m]
  Eigen::VectorXd tilts;     // height of the tip of the base's z axis: 1 upright, -1 upside down

  // ---- Joint motion: for each link but the base, its orientation relative to the base as w, x, y
  // and z, each in all of the samples.
  using Samples = Eigen::Array<float, kPostures, 1>;
  std::vector<std::array<Samples, 4>> postures;

  // ---- Contact rhythm, one value for each link.
  Eigen::VectorXd contact_shares;  // share of the time in which it touches the floor
  Eigen::VectorXd touchdowns;      // how often it comes down on it [1/s], as in a second at least
};

// `links`: those of the motion, with their shapes; the first is the base. `scale`: of their robot.
Behavior DescribeBehavior(const Motion& motion, const std::vector<robot::Link>& links,
                          double scale);

// How different two behaviors of one robot are. Each part is 1 where a person begins to call them
// different: a pace apart by 0.15 m/s, 0.6 of a turn more, ... (behavior.cpp).
struct BehaviorDistance {
  double base = 0;
  double joints = 0;
  double contacts = 0;

  double total() const;  // the root of the sum of their squares
};

BehaviorDistance DistanceBetween(const Behavior& a, const Behavior& b);

}  // namespace runtime
