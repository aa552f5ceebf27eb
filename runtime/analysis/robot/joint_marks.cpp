#include "runtime/analysis/robot/joint_marks.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "runtime/analysis/robot/axis_colors.h"

namespace runtime {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
constexpr double kWidth = 0.006, kBold = 0.01;       // of lines, in parts of the picture
constexpr double kSmallest = 0.03, kLargest = 0.07;  // radius of an arc, in parts of the robot
constexpr double kMostArc = 4;                       // arcs of more turns look like that one
constexpr double kStep = kPi / 24;                   // an arc is made of lines no longer than that

Vector3d ToEigen(const robot::Vector3& v) { return {v[0], v[1], v[2]}; }

uint32_t ColorOf(const Vector3d& axis) {
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  return kAxisColors[static_cast<size_t>(largest)];
}

// Draws the marks of one joint.
class Marker {
 public:
  Marker(const robot::RobotDescription& robot, const robot::Joint& joint,
         const std::vector<LinkFrame>& frames, double size, std::vector<Stroke>& strokes)
      : joint_(joint),
        parent_(frames[static_cast<size_t>(joint.parent)]),
        child_(frames[static_cast<size_t>(joint.child)]),
        parent_place_(ToEigen(robot.links[static_cast<size_t>(joint.parent)].position)),
        child_place_(ToEigen(robot.links[static_cast<size_t>(joint.child)].position)),
        axis_(ToEigen(joint.axis)),
        color_(ColorOf(axis_)),
        strokes_(strokes) {
    const double arm = (child_place_ - ToEigen(joint.anchor)).norm();
    radius_ = std::clamp(0.7 * arm, kSmallest * size, kLargest * size);
  }

  void MarkTurning() {
    const Vector3d anchor = InWorld(ToEigen(joint_.anchor));
    const Vector3d axis = parent_.orientation * axis_;
    Arrow(anchor - radius_ * axis, anchor + radius_ * axis);
    const double low = std::max(joint_.HasStops() ? joint_.low : -kPi, -kMostArc * kPi);
    const double high = std::min(joint_.HasStops() ? joint_.high : kPi, kMostArc * kPi);
    Line(Rim(low, 0.8), Rim(low, 1.2), kWidth);
    const int count = std::max(1, static_cast<int>(std::ceil((high - low) / kStep)));
    for (int i = 0; i < count; ++i) {
      Line(Rim(low + (high - low) * i / count, 1), Rim(low + (high - low) * (i + 1) / count, 1),
           kWidth);
    }
    const double head = std::min(0.4, (high - low) / 2);
    Line(Rim(high, 1), Rim(high - head, 1.25), kWidth);
    Line(Rim(high, 1), Rim(high - head, 0.75), kWidth);
    Line(anchor, anchor + child_.orientation * (radius_ * Zero()), kBold);
  }

  void MarkShifting() {
    const Vector3d axis = parent_.orientation * axis_;
    const Vector3d zero = InWorld(child_place_);  // where the child is at angle 0
    const double low = joint_.radius * joint_.low;
    Arrow(zero + low * axis, zero + joint_.radius * joint_.high * axis);
    Bar(zero + low * axis, kWidth);
    Bar(zero + (child_.position - zero).dot(axis) * axis, kBold);
  }

 private:
  // A point of the zero pose that moves with the parent.
  Vector3d InWorld(const Vector3d& point) const {
    return parent_.position + parent_.orientation * (point - parent_place_);
  }

  // In the zero pose, from the axis to where the child is; across the axis, of length 1.
  Vector3d Zero() const {
    const Vector3d arm = child_place_ - ToEigen(joint_.anchor);
    const Vector3d across = arm - arm.dot(axis_) * axis_;
    if (joint_.kind != robot::JointKind::kSlider && across.norm() > 0.1 * arm.norm() &&
        across.norm() > 0) {
      return across.normalized();
    }
    return axis_.unitOrthogonal();
  }

  // Of the arc's circle, which is `part` of its radius large, where the joint has this angle.
  Vector3d Rim(double angle, double part) const {
    const Vector3d turned = AngleAxisd(-angle, axis_) * Zero();
    return InWorld(ToEigen(joint_.anchor)) + parent_.orientation * (part * radius_ * turned);
  }

  void Line(const Vector3d& from, const Vector3d& to, double width) {
    strokes_.push_back({from, to, width, color_});
  }
  void Arrow(const Vector3d& from, const Vector3d& to) {
    Line(from, to, kBold);
    const Vector3d back = 0.4 * radius_ * (from - to).normalized();
    const Vector3d aside = parent_.orientation * (0.2 * radius_ * Zero());
    Line(to, to + back + aside, kBold);
    Line(to, to + back - aside, kBold);
  }
  void Bar(const Vector3d& place, double width) {
    const Vector3d aside = parent_.orientation * (0.5 * radius_ * Zero());
    Line(place - aside, place + aside, width);
  }

  const robot::Joint& joint_;
  const LinkFrame& parent_;
  const LinkFrame& child_;
  Vector3d parent_place_, child_place_;  // in the zero pose
  Vector3d axis_;
  uint32_t color_;
  double radius_ = 0;  // of arcs, and half the length of arrows [m]
  std::vector<Stroke>& strokes_;
};

}  // namespace

std::vector<Stroke> JointMarks(const robot::RobotDescription& robot,
                               const std::vector<LinkFrame>& frames, double size) {
  std::vector<Stroke> strokes;
  for (const robot::Joint& joint : robot.joints) {
    Marker marker(robot, joint, frames, size, strokes);
    switch (joint.kind) {
      case robot::JointKind::kHinge:
      case robot::JointKind::kContinuous:
        marker.MarkTurning();
        break;
      case robot::JointKind::kSlider:
        marker.MarkShifting();
        break;
    }
  }
  return strokes;
}

}  // namespace runtime
