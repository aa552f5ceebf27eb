#include "runtime/analysis/behavior/behavior.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "runtime/analysis/behavior/floor_distance.h"

namespace runtime {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Two behaviors that differ by this much in one of these, and in nothing else, have a distance
// of 1.
constexpr double kVelocity = 0.15;     // [m/s]
constexpr double kTurns = 0.6;         // [full turns]
constexpr double kHeight = 0.1;        // mean over the time, ordered by height [m]
constexpr double kTilt = 0.5;          // the same of the tilt: upright to lying is 1
constexpr double kPosture = 0.5;       // root mean square over the links [rad]
constexpr double kContactShare = 0.3;  // root mean square over the links that touch the floor
constexpr double kTouchdowns = 1;      // the same [1/s]

// One touchdown more makes no other behavior of an episode that is over in a moment: as if it had
// lasted so long [s].
constexpr double kLeastDuration = 1;

// A link that is on the floor for less of the time tells nothing of the rhythm.
constexpr double kLeastContact = 0.02;

VectorXd Quantiles(std::vector<double> values) {
  std::ranges::sort(values);
  VectorXd quantiles(Behavior::kQuantiles);
  const auto count = static_cast<double>(values.size());
  for (int i = 0; i < Behavior::kQuantiles; ++i) {
    quantiles[i] = values[static_cast<size_t>(count * (i + 0.5) / Behavior::kQuantiles)];
  }
  return quantiles;
}

Vector2d MeanVelocity(const Motion& motion) {
  if (motion.frame_count() < 2) return Vector2d::Zero();
  const Vector3d way = motion.position(motion.frame_count() - 1, 0) - motion.position(0, 0);
  const Vector3d faced = motion.orientation(0, 0) * Vector3d::UnitX();
  // One that lies on its back or belly faces up or down: then the world's x axis is forward.
  const Vector2d flat = faced.head<2>();
  const Vector2d forward = flat.norm() > 0.1 ? flat.normalized() : Vector2d::UnitX();
  const Vector2d left(-forward.y(), forward.x());
  return Vector2d(way.head<2>().dot(forward), way.head<2>().dot(left)) / motion.duration();
}

// The rotation from `a` to `b` as a vector in the frame of `a` [rad].
Vector3d Rotation(const Quaterniond& a, const Quaterniond& b) {
  const Eigen::AngleAxisd rotation(a.conjugate() * b);
  return rotation.angle() * rotation.axis();
}

Vector3d Turns(const Motion& motion) {
  Vector3d angles = Vector3d::Zero();
  for (int frame = 1; frame < motion.frame_count(); ++frame) {
    angles += Rotation(motion.orientation(frame - 1, 0), motion.orientation(frame, 0));
  }
  return angles / (2 * std::numbers::pi);
}

// Takes the posture in `frame` as the one of this number.
void TakePosture(const Motion& motion, int frame, int number, Behavior& behavior) {
  const Quaterniond to_base = motion.orientation(frame, 0).conjugate();
  for (int link = 1; link < motion.link_count; ++link) {
    const Quaterniond relative = to_base * motion.orientation(frame, link);
    auto& [w, x, y, z] = behavior.postures[static_cast<size_t>(link - 1)];
    w[number] = static_cast<float>(relative.w());
    x[number] = static_cast<float>(relative.x());
    y[number] = static_cast<float>(relative.y());
    z[number] = static_cast<float>(relative.z());
  }
}

// Fills in what is known of the contacts of one link.
void DescribeContacts(const Motion& motion, const robot::LinkShape& shape, int link, double scale,
                      Behavior& behavior) {
  bool touches = false;
  int frames_down = 0;
  int touchdowns = 0;
  for (int frame = 0; frame < motion.frame_count(); ++frame) {
    const double lowest =
        LowestPoint(shape, motion.position(frame, link).z(), motion.orientation(frame, link)) /
        scale;
    const bool touches_now =
        lowest < (touches ? Behavior::kLiftedDistance : Behavior::kFloorDistance);
    if (touches_now && !touches && frame > 0) ++touchdowns;
    touches = touches_now;
    frames_down += touches ? 1 : 0;
  }
  behavior.contact_shares[link] = static_cast<double>(frames_down) / motion.frame_count();
  const double duration = motion.duration() / std::sqrt(scale);
  behavior.touchdowns[link] = touchdowns / std::max(duration, kLeastDuration);
}

double Square(double value) { return value * value; }

// Mean of the difference of two spreads: how far values have to be moved to make one the other.
double SpreadDistance(const VectorXd& a, const VectorXd& b) { return (a - b).cwiseAbs().mean(); }

// How far each posture of `a` is from the nearest one of `b`, and the other way round, on average.
// Two postures are apart by the root mean square over the links of the angle between their
// orientations, each taken as the chord of the arc, which is the angle where it is small [rad].
double MeanDistanceToNearest(const Behavior& a, const Behavior& b) {
  using Samples = Behavior::Samples;
  const auto angle = [links = static_cast<float>(a.postures.size())](float squares) {
    return std::sqrt(std::max(0.f, 4 * (squares / links)));
  };
  Samples nearest = Samples::Constant(std::numeric_limits<float>::infinity());  // to those of b
  double from_a = 0;
  double from_b = 0;
  for (int posture = 0; posture < Behavior::kPostures; ++posture) {
    Samples squares = Samples::Zero();  // of the sines of half the angles, summed over the links
    for (size_t link = 0; link < a.postures.size(); ++link) {
      const auto& [aw, ax, ay, az] = a.postures[link];
      const auto& [bw, bx, by, bz] = b.postures[link];
      const Samples cosines =
          (aw[posture] * bw + ay[posture] * by) + (ax[posture] * bx + az[posture] * bz);
      squares += 1 - cosines.square();
    }
    from_a += angle(squares.minCoeff());
    nearest = nearest.min(squares);
  }
  for (const float squares : nearest) from_b += angle(squares);
  return (from_a / Behavior::kPostures + from_b / Behavior::kPostures) / 2;
}

double BaseDistance(const Behavior& a, const Behavior& b) {
  return std::sqrt(Square((a.velocity - b.velocity).norm() / kVelocity) +
                   Square((a.turns - b.turns).norm() / kTurns) +
                   Square(SpreadDistance(a.heights, b.heights) / kHeight) +
                   Square(SpreadDistance(a.tilts, b.tilts) / kTilt));
}

double ContactDistance(const Behavior& a, const Behavior& b) {
  double shares = 0;
  double touchdowns = 0;
  int links = 0;
  for (Eigen::Index link = 0; link < a.contact_shares.size(); ++link) {
    if (std::max(a.contact_shares[link], b.contact_shares[link]) < kLeastContact) continue;
    ++links;
    shares += Square((a.contact_shares[link] - b.contact_shares[link]) / kContactShare);
    touchdowns += Square((a.touchdowns[link] - b.touchdowns[link]) / kTouchdowns);
  }
  return links == 0 ? 0 : std::sqrt((shares + touchdowns) / links);
}

}  // namespace

Behavior DescribeBehavior(const Motion& motion, const std::vector<robot::Link>& links,
                          double scale) {
  Behavior behavior;
  behavior.velocity = MeanVelocity(motion) / std::sqrt(scale);
  behavior.turns = Turns(motion);
  std::vector<double> heights;
  std::vector<double> tilts;
  for (int frame = 0; frame < motion.frame_count(); ++frame) {
    heights.push_back(motion.position(frame, 0).z() / scale);
    tilts.push_back((motion.orientation(frame, 0) * Vector3d::UnitZ()).z());
  }
  behavior.heights = Quantiles(std::move(heights));
  behavior.tilts = Quantiles(std::move(tilts));
  behavior.postures.resize(static_cast<size_t>(motion.link_count - 1));
  for (int i = 0; i < Behavior::kPostures; ++i) {
    const double part = static_cast<double>(i) / (Behavior::kPostures - 1);
    const auto frame = static_cast<int>(std::lround(part * (motion.frame_count() - 1)));
    TakePosture(motion, frame, i, behavior);
  }
  behavior.contact_shares.resize(motion.link_count);
  behavior.touchdowns.resize(motion.link_count);
  for (int link = 0; link < motion.link_count; ++link) {
    DescribeContacts(motion, links[static_cast<size_t>(link)].shape, link, scale, behavior);
  }
  return behavior;
}

double BehaviorDistance::total() const {
  return std::sqrt(Square(base) + Square(joints) + Square(contacts));
}

BehaviorDistance DistanceBetween(const Behavior& a, const Behavior& b) {
  return {BaseDistance(a, b), MeanDistanceToNearest(a, b) / kPosture, ContactDistance(a, b)};
}

}  // namespace runtime
