#include "runtime/analysis/robot/held_pose.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "runtime/analysis/robot/shaking.h"
#include "runtime/base/thread_seconds.h"
#include "runtime/training/simulation/ground_height.h"
#include "runtime/training/simulation/world.h"

namespace runtime {
namespace {

std::vector<LinkFrame> FramesOf(const RobotBody& body) {
  std::vector<LinkFrame> frames;
  for (int i = 0; i < body.link_count(); ++i) {
    const dReal* p = dBodyGetPosition(body.body(i));
    const dReal* q = dBodyGetQuaternion(body.body(i));
    frames.push_back({{p[0], p[1], p[2]}, {q[0], q[1], q[2], q[3]}});
  }
  return frames;
}

std::vector<Overlap> OverlapsIn(const Collision& collision) {
  std::map<std::pair<int, int>, double> deepest;
  for (const Contact& contact : collision.contacts()) {
    double& depth = deepest[std::minmax(contact.first, contact.second)];
    depth = std::max(depth, contact.geometry.depth);
  }
  std::vector<Overlap> overlaps;
  for (const auto& [pair, depth] : deepest) overlaps.push_back({pair.first, pair.second, depth});
  std::ranges::stable_sort(overlaps, std::greater(), &Overlap::depth);
  return overlaps;
}

// Around all shapes, where the links are.
double SizeOf(const RobotBody& body) {
  dReal low[3] = {dInfinity, dInfinity, dInfinity};
  dReal high[3] = {-dInfinity, -dInfinity, -dInfinity};
  for (int i = 0; i < body.link_count(); ++i) {
    dReal box[6];
    dGeomGetAABB(body.geom(i), box);
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], box[2 * k]);
      high[k] = std::max(high[k], box[2 * k + 1]);
    }
  }
  return std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

void Compare(HeldPose& held) {
  const LinkFrame& start = held.start.front();
  const LinkFrame& end = held.end.front();
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  const double cosine = (start.orientation * z).dot(end.orientation * z);
  held.tilt = std::acos(std::clamp(cosine, -1., 1.));
  const Eigen::Vector3d way = end.position - start.position;
  held.drift = way.head<2>().norm();
  held.sink = -way.z();
}

}  // namespace

bool HeldPose::Stands() const {
  constexpr double kMostTilt = 0.35;  // [rad]: 20 degrees
  constexpr double kMostSink = 0.1;   // of its size
  return failure.empty() && tilt < kMostTilt && sink < kMostSink * size;
}

HeldPose HoldPose(const robot::RobotDescription& robot, const Profile& profile,
                  const robot::Pose& pose, double seconds) {
  HeldPose held;
  held.pose = pose.name;
  held.profile = profile.name;
  World world(robot, profile, pose);
  held.size = SizeOf(world.body());
  held.overlaps = OverlapsIn(world.collision());
  held.start = FramesOf(world.body());
  held.end = held.start;
  Shaking shaking(robot.joints.size(), world.physics_time_step(), seconds / 2);
  const double began = ThreadSeconds();
  const auto steps = static_cast<int>(std::ceil(seconds / world.physics_time_step() - 1e-6));
  try {
    for (int i = 0; i < steps; ++i) {
      world.Step(pose.joint_angles);
      held.seconds = (i + 1) * world.physics_time_step();
      shaking.Add(held.seconds, world.controller().rates());
    }
  } catch (const OdeFailure& failure) {
    held.failure = failure.what();
  }
  held.real_time_factor = held.seconds / std::max(ThreadSeconds() - began, 1e-9);
  // What a simulation is like that has diverged nobody wants to see.
  if (held.failure.empty()) held.end = FramesOf(world.body());
  Compare(held);
  std::tie(held.chattering_joint, held.chatter) = shaking.Worst();
  return held;
}

}  // namespace runtime
