// What a task senses of the things in its world: the one list from which the compiler knows names,
// types and units, and the environment knows what to compute.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "plugins/world/world_description.h"

namespace world {

enum class Quantity { kPosition, kOrientation, kVelocity, kAngularVelocity, kContact };

struct ThingSensor {
  std::string name;  // "ball.position"
  size_t thing;      // index
  Quantity quantity;
  std::string_view type;  // in the task language: "vec3", "bool[link]"
  std::string_view unit;
  std::string_view doc;
  // The elements while nothing has been moved yet; empty: all 0 or false.
  std::vector<double> at_rest;
  // No element of it is further from 0; infinity where nothing is known.
  double most = robot::kUnlimited;
};

// In the order of the things; those of one in the order of Quantity.
std::vector<ThingSensor> SensorsOf(const WorldDescription& world);

// The first part of the names of those that tell which links touch a thing: "contact_with.ball".
inline constexpr std::string_view kContactWith = "contact_with";

}  // namespace world
