#include "runtime/training/simulation/mjcf_text.h"

#include <algorithm>
#include <numbers>

#include "runtime/base/user_error.h"
#include "runtime/training/simulation/link_motion.h"

namespace runtime {
namespace {

using Eigen::Quaterniond;

constexpr double kMostFriction = 100;  // where nothing slides

// MuJoCo refuses moments of which one is larger than the other two together, as no body has them;
// those of a thin plate may be so by rounding.
Vector3 PossibleMoments(const Vector3& moments, const std::string& name) {
  constexpr double kRounding = 1e-9;
  Vector3 possible = moments;
  int largest = 0;
  moments.maxCoeff(&largest);
  const double others = moments[(largest + 1) % 3] + moments[(largest + 2) % 3];
  if (moments[largest] > others * (1 + kRounding)) {
    throw UserError(fmt::format(
        "MuJoCo cannot simulate the link `{}`: no body has the moments of inertia {:.3g}, {:.3g} "
        "and {:.3g} kg m^2, of which one is larger than the other two together; correct its "
        "`inertia`, or choose another profile",
        name, moments[0], moments[1], moments[2]));
  }
  possible[largest] = std::min(moments[largest], others);
  return possible;
}

// MuJoCo's capsules and cylinders lie along z.
Quaterniond AlongAxis(int axis) {
  constexpr double kQuarter = std::numbers::pi / 2;
  if (axis == 0) return Quaterniond(Eigen::AngleAxisd(kQuarter, Eigen::Vector3d::UnitY()));
  if (axis == 1) return Quaterniond(Eigen::AngleAxisd(kQuarter, Eigen::Vector3d::UnitX()));
  return Quaterniond::Identity();
}

std::string SizeAndType(const std::string& name, const robot::LinkShape& shape) {
  switch (shape.kind) {
    case robot::ShapeKind::kBox:
      return fmt::format("type='box' size='{} {} {}'", shape.size[0] / 2, shape.size[1] / 2,
                         shape.size[2] / 2);
    case robot::ShapeKind::kCapsule:
      return fmt::format("type='capsule' size='{} {}'", shape.radius,
                         shape.length / 2 - shape.radius);
    case robot::ShapeKind::kCylinder:
      return fmt::format("type='cylinder' size='{} {}'", shape.radius, shape.length / 2);
    case robot::ShapeKind::kSphere:
      return fmt::format("type='sphere' size='{}'", shape.radius);
    case robot::ShapeKind::kConvex:
      break;
  }
  return fmt::format("type='mesh' mesh='{}'", name);
}

void AppendTurnedShape(const std::string& name, const robot::LinkShape& shape,
                       const robot::Vector3& position, const Quaterniond& turn, MjcfText& text) {
  const bool has_axis =
      shape.kind == robot::ShapeKind::kCapsule || shape.kind == robot::ShapeKind::kCylinder;
  Append(text, "<geom name='{}' {} pos='{}' quat='{}'/>", name, SizeAndType(name, shape),
         Numbers(position), Numbers(turn * AlongAxis(has_axis ? shape.axis : 2)));
}

Quaterniond TurnOf(const robot::Quaternion& q) { return {q[0], q[1], q[2], q[3]}; }

}  // namespace

std::string Numbers(const robot::Vector3& v) { return fmt::format("{} {} {}", v[0], v[1], v[2]); }

std::string Numbers(const Quaterniond& q) {
  return fmt::format("{} {} {} {}", q.w(), q.x(), q.y(), q.z());
}

void AppendShape(const std::string& name, const robot::LinkShape& shape, MjcfText& text) {
  AppendTurnedShape(name, shape, shape.position, TurnOf(shape.orientation), text);
}

void AppendShapeAt(const std::string& name, const robot::LinkShape& shape,
                   const robot::Vector3& position, const robot::Quaternion& orientation,
                   MjcfText& text) {
  const Quaterniond turn = TurnOf(orientation);
  const Vector3 place = ToEigen(position.data()) + turn * ToEigen(shape.position.data());
  AppendTurnedShape(name, shape, {place[0], place[1], place[2]}, turn * TurnOf(shape.orientation),
                    text);
}

void AppendInertia(const std::string& name, dBodyID body, MjcfText& text) {
  const LinkInertia inertia = InertiaOf(body);
  const Vector3 moments = PossibleMoments(inertia.principal, name);
  Append(text, "<inertial pos='0 0 0' mass='{}' quat='{}' diaginertia='{} {} {}'/>", inertia.mass,
         Numbers(Quaterniond(inertia.axes)), moments[0], moments[1], moments[2]);
}

void AppendPair(const std::string& first, const std::string& second, double friction,
                MjcfText& text) {
  const double limited = std::min(friction, kMostFriction);
  Append(text, "<pair geom1='{}' geom2='{}' condim='{}' friction='{} {} 0 0 0'/>\n", first, second,
         friction > 0 ? 3 : 1, limited, limited);
}

}  // namespace runtime
