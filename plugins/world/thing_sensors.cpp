#include "plugins/world/thing_sensors.h"

#include <array>

namespace world {
namespace {

struct SensorKind {
  Quantity quantity;
  std::string_view name;
  std::string_view type;
  std::string_view unit;
  std::string_view doc;
  double most = robot::kUnlimited;
};

constexpr std::array kSensorKinds = {
    SensorKind{Quantity::kPosition, "position", "vec3", "m",
               "center of the thing, in the world frame"},
    SensorKind{Quantity::kOrientation, "orientation", "quat", "",
               "orientation of the thing (w, x, y, z), from its own frame to the world frame", 1},
    SensorKind{Quantity::kVelocity, "velocity", "vec3", "m/s",
               "velocity of the thing's center, in the world frame", robot::kFastest},
    SensorKind{Quantity::kAngularVelocity, "angular_velocity", "vec3", "rad/s",
               "angular velocity of the thing, in the world frame", robot::kFastestRotation},
    SensorKind{Quantity::kContact, kContactWith, "bool[link]", "",
               "whether each link touches the thing, low-pass filtered like `contact`"},
};

std::string NameOf(const SensorKind& kind, const std::string& thing) {
  const std::string name(kind.name);
  return kind.quantity == Quantity::kContact ? name + '.' + thing : thing + '.' + name;
}

std::vector<double> AtRest(Quantity quantity, const Thing& thing) {
  if (quantity == Quantity::kPosition) return {thing.position.begin(), thing.position.end()};
  if (quantity == Quantity::kOrientation)
    return {thing.orientation.begin(), thing.orientation.end()};
  return {};
}

}  // namespace

std::vector<ThingSensor> SensorsOf(const WorldDescription& world) {
  std::vector<ThingSensor> sensors;
  for (size_t i = 0; i < world.things.size(); ++i) {
    const Thing& thing = world.things[i];
    for (const SensorKind& kind : kSensorKinds) {
      sensors.push_back({NameOf(kind, thing.name), i, kind.quantity, kind.type, kind.unit, kind.doc,
                         AtRest(kind.quantity, thing), kind.most});
    }
  }
  return sensors;
}

}  // namespace world
