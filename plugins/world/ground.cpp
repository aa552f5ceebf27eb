#include "plugins/world/ground.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/variant/overloaded.h"
#include "plugins/robot/rotation.h"
#include "plugins/robot/shape_extent.h"

namespace world {
namespace {

Quaternion Multiply(const Quaternion& a, const Quaternion& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
          a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

int StepBelow(const Steps& steps, double x) {
  if (x < steps.start) return 0;
  return std::min(steps.count, 1 + static_cast<int>((x - steps.start) / steps.depth));
}

// Between the four heights around a place; 0 outside of the map.
double Interpolate(const HeightMap& map, double x, double y) {
  const double column = ((x - map.center_x) / map.size_x + 0.5) * (map.columns - 1);
  const double row = ((y - map.center_y) / map.size_y + 0.5) * (map.rows - 1);
  if (!(column >= 0 && row >= 0 && column <= map.columns - 1 && row <= map.rows - 1)) return 0;
  const int i = std::min(static_cast<int>(column), map.columns - 2);
  const int j = std::min(static_cast<int>(row), map.rows - 2);
  const double u = column - i;
  const double v = row - j;
  return (1 - v) * ((1 - u) * map.At(i, j) + u * map.At(i + 1, j)) +
         v * ((1 - u) * map.At(i, j + 1) + u * map.At(i + 1, j + 1));
}

double HighestOf(const HeightMap& map, double x, double y, double radius) {
  double highest = Interpolate(map, x, y);
  // The slopes to the points just outside reach in.
  const double reach =
      radius + std::hypot(map.size_x / (map.columns - 1), map.size_y / (map.rows - 1));
  for (int j = 0; j < map.rows; ++j) {
    for (int i = 0; i < map.columns; ++i) {
      const double dx = map.center_x + map.size_x * (i / (map.columns - 1.0) - 0.5) - x;
      const double dy = map.center_y + map.size_y * (j / (map.rows - 1.0) - 0.5) - y;
      if (dx * dx + dy * dy <= reach * reach) highest = std::max(highest, map.At(i, j));
    }
  }
  return highest;
}

double HighestWithin(const Ground& ground, double x, double y, double radius) {
  return std::visit(
      variant::Overloaded{
          [](const Plane&) { return 0.0; }, [&](const Slope&) { return HeightAt(ground, x, y); },
          [&](const Steps& steps) { return steps.height * StepBelow(steps, x + radius); },
          [&](const HeightMap& map) { return HighestOf(map, x, y, radius); }},
      ground.shape);
}

}  // namespace

double HeightAt(const Ground& ground, double x, double y) {
  return std::visit(
      variant::Overloaded{[](const Plane&) { return 0.0; },
                          [&](const Slope& slope) {
                            const double up =
                                x * std::cos(slope.direction) + y * std::sin(slope.direction);
                            return up * std::tan(slope.angle);
                          },
                          [&](const Steps& steps) { return steps.height * StepBelow(steps, x); },
                          [&](const HeightMap& map) { return Interpolate(map, x, y); }},
      ground.shape);
}

Vector3 NormalOf(const Ground& ground) {
  const auto* slope = std::get_if<Slope>(&ground.shape);
  if (slope == nullptr) return {0, 0, 1};
  return {-std::sin(slope->angle) * std::cos(slope->direction),
          -std::sin(slope->angle) * std::sin(slope->direction), std::cos(slope->angle)};
}

// About the level axis to the right of the direction in which the ground rises.
Quaternion TurnOf(const Ground& ground) {
  const auto* slope = std::get_if<Slope>(&ground.shape);
  if (slope == nullptr) return {1, 0, 0, 0};
  const double sine = std::sin(slope->angle / 2);
  return {std::cos(slope->angle / 2), sine * std::sin(slope->direction),
          -sine * std::cos(slope->direction), 0};
}

std::vector<Block> BlocksOf(const Ground& ground) {
  std::vector<Block> blocks;
  const auto* steps = std::get_if<Steps>(&ground.shape);
  if (steps == nullptr) return blocks;
  for (int i = 0; i < steps->count; ++i) {
    const double low = steps->start + i * steps->depth;
    const bool is_last = i + 1 == steps->count;
    blocks.push_back({low, low + (is_last ? kWidth : steps->depth), (i + 1) * steps->height});
  }
  return blocks;
}

void PutDown(const Ground& ground, double x, double y, const Quaternion& turn, Thing& thing) {
  thing.orientation = Multiply(TurnOf(ground), turn);
  const Vector3 up = NormalOf(ground);
  const auto matrix = robot::RotationMatrix(thing.orientation);
  std::array<double, 3> down{};  // in the thing's own frame
  for (int i = 0; i < 3; ++i)
    down[i] = -(matrix[i] * up[0] + matrix[3 + i] * up[1] + matrix[6 + i] * up[2]);
  const double reach = robot::ReachAlong(thing.shape, down);
  const double height = HighestWithin(ground, x, y, robot::RadiusAround(thing.shape));
  thing.position = {x + reach * up[0], y + reach * up[1], height + reach * up[2]};
}

}  // namespace world
