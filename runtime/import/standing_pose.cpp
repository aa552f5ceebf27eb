#include "runtime/import/standing_pose.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "runtime/analysis/robot/held_pose.h"
#include "runtime/base/in_parallel.h"
#include "runtime/training/learning/cma_es.h"
#include "runtime/training/simulation/collision.h"
#include "runtime/training/simulation/ground_height.h"
#include "runtime/training/simulation/ode_library.h"

namespace runtime {
namespace {

using Eigen::VectorXd;
using robot::RobotDescription;

constexpr int kGenerations = 40;
constexpr double kSeconds = 0.4;    // for which a candidate is held [s]
constexpr double kSpread = 0.3;     // of the candidates at first, as a part of each joint's width
constexpr double kMargin = 0.01;    // to its stops, likewise
constexpr double kMostWidth = 2;    // [rad] or [m]
constexpr double kOfMoving = 10;    // the cost of a rad, or of going as far as the robot is large
constexpr double kPressed = 0.001;  // into the ground, which shows what stands on it [m]
constexpr double kDeepest = 0.005;  // of the robot's size, that links may be within each other
constexpr double kLowest = 0.5;     // for the base, as a part of its height in the file's pose

// What a coordinate of the search moves.
robot::DofConfiguration CoordinatesOf(const RobotDescription& robot) {
  const auto symmetric =
      std::ranges::find(robot.dof_configurations, "symmetric", &robot::DofConfiguration::name);
  if (symmetric != robot.dof_configurations.end()) return *symmetric;
  robot::DofConfiguration each;
  for (int joint = 0; joint < static_cast<int>(robot.joints.size()); ++joint) {
    if (!robot.GainsOf(robot.joints[static_cast<size_t>(joint)]).HasMotor()) continue;
    each.couplings.push_back({joint, each.dof(), 1});
    each.representatives.push_back(joint);
  }
  return each;
}

class PoseSearch {
 public:
  PoseSearch(const RobotDescription& robot, const robot::Pose& pose)
      : robot_(robot),
        first_(pose),
        coordinates_(CoordinatesOf(robot)),
        is_end_(robot.links.size(), true) {
    for (const robot::Branch& branch : robot.Branches())
      is_end_[static_cast<size_t>(branch.parent)] = false;
  }

  std::optional<robot::Pose> Run() {
    const int dimensions = coordinates_.dof();
    if (dimensions == 0) return std::nullopt;
    Random random(1);
    CmaEs search(VectorXd::Zero(dimensions), kSpread, 2 * CmaEs::DefaultPopulation(dimensions));
    while (search.generation() < kGenerations) RunGeneration(search, random);
    return best_;
  }

 private:
  // Its candidates are foreseen, held on all cores, and then told of in their order.
  void RunGeneration(CmaEs& search, Random& random) {
    Random foreseeing = random;
    std::vector<VectorXd> places;
    for (int i = 0; i < search.population(); ++i) places.push_back(search.Foresee(foreseeing));
    std::vector<robot::Pose> poses(places.size());
    std::vector<double> costs(places.size(), std::numeric_limits<double>::infinity());
    InParallel(places.size(), [&](size_t i) {
      try {
        poses[i] = PoseAt(places[i]);
        costs[i] = CostOf(poses[i]) + places[i].squaredNorm() / search.dimensions();
      } catch (const OdeFailure&) {
        // Nothing that could be simulated.
      }
    });
    for (const double cost : costs) {
      search.Ask(random);
      search.Tell(cost);
    }
    const auto best = std::ranges::min_element(costs) - costs.begin();
    Consider(poses[static_cast<size_t>(best)], costs[static_cast<size_t>(best)]);
  }

  // Some that hardly move at first fall slowly.
  void Consider(const robot::Pose& pose, double cost) {
    if (cost >= best_cost_ || !Stands(pose)) return;
    best_cost_ = cost;
    best_ = pose;
  }

  // `place`: how far each coordinate is from the first pose, as a part of its width.
  robot::Pose PoseAt(const VectorXd& place) const {
    robot::Pose pose = first_;
    for (const robot::Coupling& coupling : coordinates_.couplings) {
      const auto number = static_cast<size_t>(coupling.joint);
      const robot::Joint& joint = robot_.joints[number];
      const double width = std::min(joint.high - joint.low, kMostWidth);
      double& angle = pose.joint_angles[number];
      const double margin = kMargin * width;
      angle = std::clamp(angle + coupling.factor * width * place[coupling.coordinate],
                         joint.low + margin, joint.high - margin);
    }
    return PutOnGround(robot_, std::move(pose));
  }

  // A robot that lies on its trunk does not.
  bool Stands(const robot::Pose& pose) const {
    const HeldPose held = HoldPose(robot_, FindProfile("fast-tree"), pose);
    return held.Stands() && held.end.front().position.z() > kLowest * first_.position[2];
  }

  // 0 for a robot that stands still, on the ends of its limbs, with its base as high as in the
  // file's pose.
  double CostOf(robot::Pose pose) const {
    pose.position[2] -= kPressed;
    const HeldPose held = HoldPose(robot_, FindProfile("fast-tree"), pose, kSeconds);
    if (!held.failure.empty()) return std::numeric_limits<double>::infinity();
    const double moved = held.tilt + (std::abs(held.sink) + held.drift) / held.size;
    const double height = held.end.front().position.z() / first_.position[2];
    const auto is_wrong = [&](const Overlap& overlap) {
      if (overlap.first == Contact::kGround) return !is_end_[static_cast<size_t>(overlap.second)];
      return overlap.depth > kDeepest * held.size;
    };
    const auto wrong = static_cast<double>(std::ranges::count_if(held.overlaps, is_wrong));
    return kOfMoving * moved + (1 - height) + wrong;
  }

  const RobotDescription& robot_;
  const robot::Pose& first_;
  const robot::DofConfiguration coordinates_;
  std::vector<bool> is_end_;  // of a limb: for each link whether nothing hangs on it
  std::optional<robot::Pose> best_;
  double best_cost_ = std::numeric_limits<double>::infinity();
};

}  // namespace

std::optional<robot::Pose> FindStandingPose(const RobotDescription& robot,
                                            const robot::Pose& pose) {
  return PoseSearch(robot, pose).Run();
}

robot::Pose PutOnGround(const RobotDescription& robot, robot::Pose pose) {
  const double lowest = LowestPoint(robot, pose);
  if (robot.has_fixed_base) {
    pose.position[2] -= std::min(lowest, 0.);
  } else {
    pose.position = {0, 0, pose.position[2] - lowest};
  }
  return pose;
}

}  // namespace runtime
