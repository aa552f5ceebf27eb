#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <span>
#include <vector>

#include "plugins/robot/sensors.h"

namespace robot {
namespace {

constexpr std::array kWithoutLimit = {
    SensorId::kBasePosition,        SensorId::kBaseVelocity,        SensorId::kBaseAngularVelocity,
    SensorId::kBaseAcceleration,    SensorId::kJointVelocity,       SensorId::kJointAcceleration,
    SensorId::kJointTarget,         SensorId::kLinkPosition,        SensorId::kLinkVelocity,
    SensorId::kLinkAngularVelocity, SensorId::kContactForce,        SensorId::kSitePosition,
    SensorId::kSiteVelocity,        SensorId::kSiteAngularVelocity, SensorId::kSiteAcceleration};

// A joint gives way a little at its stops; see docs/simulation.md.
constexpr double kGiveOfStops = 0.1;  // [rad]

std::vector<Range> AngleRanges(const RobotDescription& robot) {
  std::vector<Range> ranges;
  for (const Joint& joint : robot.joints) {
    ranges.push_back({joint.low - kGiveOfStops, joint.high + kGiveOfStops});
  }
  return ranges;
}

std::vector<Range> TorqueRanges(const RobotDescription& robot) {
  std::vector<Range> ranges;
  for (const Joint& joint : robot.joints) {
    const double most = robot.GainsOf(joint).max_torque;
    ranges.push_back({-most, most});
  }
  return ranges;
}

double Distance(const Vector3& a, const Vector3& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// The longest way between the centers of two links, along what joins them.
double LongestWay(const Branch& branch, const RobotDescription& robot) {
  const Vector3& parent = robot.links[branch.parent].position;
  const Vector3& child = robot.links[branch.child].position;
  const auto over = [&](const Vector3& anchor) {
    return Distance(parent, anchor) + Distance(anchor, child);
  };
  if (branch.joint < 0) {
    const Mount& mount = robot.mounts[branch.mount];
    return mount.kind == MountKind::kBall ? over(mount.anchor) : Distance(parent, child);
  }
  const Joint& joint = robot.joints[branch.joint];
  if (joint.kind != JointKind::kSlider) return over(joint.anchor);
  return Distance(parent, child) + joint.radius * std::max(-joint.low, joint.high);
}

// How far each link's center can be from the base's: the way along the joints, stretched out.
std::vector<double> Reaches(const RobotDescription& robot) {
  std::vector<double> reaches(robot.links.size(), 0);
  for (const Branch& branch : robot.Branches()) {
    reaches[branch.child] = reaches[branch.parent] + LongestWay(branch, robot);
  }
  return reaches;
}

std::vector<Range> RangesOf(SensorId sensor, const RobotDescription& robot) {
  return RangesOf(Sensors()[static_cast<size_t>(sensor)], robot);
}

std::vector<Range> LinkPositionRanges(const RobotDescription& robot) {
  const std::vector<Range> base = RangesOf(SensorId::kBasePosition, robot);
  std::vector<Range> ranges;
  for (const double reach : Reaches(robot)) {
    for (const Range& range : base) ranges.push_back({range.low - reach, range.high + reach});
  }
  return ranges;
}

// The ranges of one vector of an array's.
std::span<const Range> VectorOf(const std::vector<Range>& ranges, int entry) {
  return std::span(ranges).subspan(3 * static_cast<size_t>(entry), 3);
}

double ArmLength(const Site& site, const RobotDescription& robot) {
  const Vector3 arm = robot.ArmOf(site);
  return std::hypot(arm[0], arm[1], arm[2]);
}

std::vector<Range> SitePositionRanges(const RobotDescription& robot) {
  const std::vector<Range> links = RangesOf(SensorId::kLinkPosition, robot);
  std::vector<Range> ranges;
  for (const Site& site : robot.sites) {
    const double arm = ArmLength(site, robot);
    for (const Range& range : VectorOf(links, site.link))
      ranges.push_back({range.low - arm, range.high + arm});
  }
  return ranges;
}

// The longest vector that the ranges of its elements leave.
double LargestNorm(std::span<const Range> ranges) {
  double sum = 0;
  for (const Range& range : ranges) {
    const double largest = std::max(-range.low, range.high);
    sum += largest * largest;
  }
  return std::sqrt(sum);
}

// As fast as the link, and as what turns with it.
std::vector<Range> SiteVelocityRanges(const RobotDescription& robot) {
  const std::vector<Range> links = RangesOf(SensorId::kLinkVelocity, robot);
  const std::vector<Range> rotations = RangesOf(SensorId::kLinkAngularVelocity, robot);
  std::vector<Range> ranges;
  for (const Site& site : robot.sites) {
    const double turning = LargestNorm(VectorOf(rotations, site.link)) * ArmLength(site, robot);
    for (const Range& range : VectorOf(links, site.link))
      ranges.push_back({range.low - turning, range.high + turning});
  }
  return ranges;
}

std::vector<Range> SiteAngularVelocityRanges(const RobotDescription& robot) {
  const std::vector<Range> links = RangesOf(SensorId::kLinkAngularVelocity, robot);
  std::vector<Range> ranges;
  for (const Site& site : robot.sites)
    std::ranges::copy(VectorOf(links, site.link), std::back_inserter(ranges));
  return ranges;
}

// The fastest change, in one time step.
double LargestChange(const Range& velocity, const RobotDescription& robot) {
  return (velocity.high - velocity.low) / robot.controller.time_step;
}

std::vector<Range> JointAccelerationRanges(const RobotDescription& robot) {
  std::vector<Range> ranges;
  for (const Range& velocity : RangesOf(SensorId::kJointVelocity, robot)) {
    const double largest = LargestChange(velocity, robot);
    ranges.push_back({-largest, largest});
  }
  return ranges;
}

// What an accelerometer can show along axes that may point anywhere.
Range AccelerationRange(std::span<const Range> velocities, const RobotDescription& robot) {
  double sum = 0;
  for (const Range& velocity : velocities) {
    sum += LargestChange(velocity, robot) * LargestChange(velocity, robot);
  }
  const double largest = std::sqrt(sum) + kGravity;
  return {-largest, largest};
}

std::vector<Range> SiteAccelerationRanges(const RobotDescription& robot) {
  const std::vector<Range> velocities = RangesOf(SensorId::kSiteVelocity, robot);
  std::vector<Range> ranges;
  for (size_t i = 0; i < robot.sites.size(); ++i) {
    const Range range = AccelerationRange(VectorOf(velocities, static_cast<int>(i)), robot);
    ranges.insert(ranges.end(), 3, range);
  }
  return ranges;
}

// What follows from other ranges where the description says nothing. One range for each element, or
// one for all.
std::vector<Range> CommonRanges(SensorId sensor, const RobotDescription& robot) {
  switch (sensor) {
    case SensorId::kTime:
      return {{.low = 0}};
    case SensorId::kBaseOrientation:
    case SensorId::kBaseRotation:
    case SensorId::kBaseForward:
    case SensorId::kBaseLeft:
    case SensorId::kBaseUp:
    case SensorId::kLinkOrientation:
    case SensorId::kSiteOrientation:
      return {{-1, 1}};
    case SensorId::kJointAngle:
      return AngleRanges(robot);
    case SensorId::kJointTorque:
      return TorqueRanges(robot);
    case SensorId::kContact:
      return {{0, 1}};
    case SensorId::kBaseAcceleration:
      return {AccelerationRange(RangesOf(SensorId::kBaseVelocity, robot), robot)};
    case SensorId::kJointAcceleration:
      return JointAccelerationRanges(robot);
    case SensorId::kLinkPosition:
      return LinkPositionRanges(robot);
    case SensorId::kLinkVelocity:
      return {{-kFastest, kFastest}};
    case SensorId::kLinkAngularVelocity:
      return {{-kFastestRotation, kFastestRotation}};
    case SensorId::kSitePosition:
      return SitePositionRanges(robot);
    case SensorId::kSiteVelocity:
      return SiteVelocityRanges(robot);
    case SensorId::kSiteAngularVelocity:
      return SiteAngularVelocityRanges(robot);
    case SensorId::kSiteAcceleration:
      return SiteAccelerationRanges(robot);
    case SensorId::kBasePosition:
    case SensorId::kBaseVelocity:
    case SensorId::kBaseAngularVelocity:
    case SensorId::kJointVelocity:
    case SensorId::kJointTarget:
    case SensorId::kContactForce:
      return {Range{}};
    case SensorId::kCount:
      break;
  }
  std::abort();
}

}  // namespace

bool IsUnlimited(SensorId sensor) {
  return std::ranges::find(kWithoutLimit, sensor) != kWithoutLimit.end();
}

std::vector<Range> RangesOf(const SensorDescription& sensor, const RobotDescription& robot) {
  const auto nominal = std::ranges::find(robot.nominal_ranges, sensor.name, &NominalRange::sensor);
  std::vector<Range> ranges =
      nominal != robot.nominal_ranges.end() ? nominal->elements : CommonRanges(sensor.id, robot);
  const auto count = static_cast<size_t>(ElementCount(sensor, robot));
  if (ranges.size() == 1) ranges.resize(count, ranges.front());
  return ranges;
}

}  // namespace robot
