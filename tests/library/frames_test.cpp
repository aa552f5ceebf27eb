// std/frames against Eigen.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "tests/library/functions.h"

namespace library {
namespace {

using Eigen::Vector3d;

Eigen::Quaterniond Rotation(const Values& values, const std::string& name) {
  const std::vector<double>& q = values.at(name);
  return {q[0], q[1], q[2], q[3]};
}

Vector3d Vector(const Values& values) {
  return Vector3d(values.at("v")[0], values.at("v")[1], values.at("v")[2]);
}

double Heading(const Values& values) {
  const Vector3d forward = Rotation(values, "q") * Vector3d::UnitX();
  return std::atan2(forward.y(), forward.x());
}

Eigen::Quaterniond HeadingFrame(const Values& values) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(Heading(values), Vector3d::UnitZ()));
}

// To (-pi, pi].
double Wrapped(double angle) {
  while (angle > std::numbers::pi) angle -= 2 * std::numbers::pi;
  while (angle <= -std::numbers::pi) angle += 2 * std::numbers::pi;
  return angle;
}

double Bearing(const Values& values) {
  const std::vector<double>& place = values.at("place");
  const std::vector<double>& from = values.at("from");
  return std::atan2(place[1] - from[1], place[0] - from[0]);
}

using Seen = Vector3d (*)(const Values&);

// One call for each element.
void AddVector(const std::string& text, Seen seen, std::vector<Call>& calls) {
  for (int i = 0; i < 3; ++i)
    calls.push_back({fmt::format("({}).{}", text, "xyz"[i]),
                     [=](const Values& values) { return seen(values)[i]; }});
}

const std::vector<Input> kFrameInputs = {{"q", "quat", -1, 1, true}, {"p", "quat", -1, 1, true},
                                         {"v", "vec3 [m/s]", -2, 2}, {"a", "real [rad]", -6, 6},
                                         {"b", "real [rad]", -6, 6}, {"place", "vec2 [m]", -3, 3},
                                         {"from", "vec2 [m]", -3, 3}};

TEST(Frames, SeeVectorsAsTheRobotDoes) {
  std::vector<Call> calls;
  AddVector(
      "to_body(q, v)",
      [](const Values& values) -> Vector3d {
        return Rotation(values, "q").inverse() * Vector(values);
      },
      calls);
  AddVector(
      "to_heading(q, v)",
      [](const Values& values) -> Vector3d {
        return HeadingFrame(values).inverse() * Vector(values);
      },
      calls);
  AddVector(
      "from_heading(q, v)",
      [](const Values& values) -> Vector3d { return HeadingFrame(values) * Vector(values); },
      calls);
  AddVector(
      "rotate(heading_frame(q), v)",
      [](const Values& values) -> Vector3d { return HeadingFrame(values) * Vector(values); },
      calls);
  AddVector(
      "gravity_in_body(q)",
      [](const Values& values) -> Vector3d {
        return Rotation(values, "q").toRotationMatrix().transpose() * Vector3d(0, 0, -1);
      },
      calls);
  ExpectEqual("std/frames", kFrameInputs, calls);
}

TEST(Frames, HaveAnglesBetweenThem) {
  ExpectEqual(
      "std/frames", kFrameInputs,
      {{"tilt(q)",
        [](const Values& values) {
          const Vector3d up = Rotation(values, "q") * Vector3d::UnitZ();
          return std::atan2(up.head<2>().norm(), up.z());
        }},
       {"angle_difference(a, b)",
        [](const Values& values) { return Wrapped(values.at("a")[0] - values.at("b")[0]); }},
       {"rotation_difference(q, p)",
        [](const Values& values) {
          return Rotation(values, "q").angularDistance(Rotation(values, "p"));
        }},
       {"bearing_of(place, from)", Bearing},
       {"turn_toward(place, from, q)",
        [](const Values& values) { return Wrapped(Bearing(values) - Heading(values)); }}});
}

}  // namespace
}  // namespace library
