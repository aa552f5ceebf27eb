#include "compiler/check/sensor_catalog.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>

#include "compiler/check/type.h"
#include "compiler/check/unit.h"
#include "plugins/robot/sensors.h"
#include "plugins/world/thing_sensors.h"

namespace compiler {
namespace {

// Reads a type of the robot's list: "vec3", "bool[link]", "vec3[link]".
Type TypeOf(std::string_view text, const std::vector<Enumeration>& enumerations) {
  const size_t bracket = text.find('[');
  auto type = FindType(text.substr(0, bracket));
  assert(type);
  if (bracket == std::string_view::npos) return *type;
  const Enumeration* index =
      FindEnumeration(enumerations, text.substr(bracket + 1, text.size() - bracket - 2));
  assert(index != nullptr);
  return ArrayOf(*type, index->size(), index->name);
}

// Of a dotted name, or all of it.
bool IsFirstPart(std::string_view part, std::string_view name) {
  return name.starts_with(part) && (name.size() == part.size() || name[part.size()] == '.');
}

Unit UnitOf(std::string_view text) {
  const auto unit = ParseUnit(text);
  assert(unit && unit->numerator == unit->denominator);
  return unit->unit;
}

}  // namespace

SensorCatalog SensorCatalog::OfRobot(const robot::RobotDescription& robot,
                                     const std::vector<Enumeration>& enumerations) {
  SensorCatalog catalog;
  for (const robot::SensorDescription& sensor : robot::SensorsOf(robot)) {
    CheckedSensor checked{.name = std::string(sensor.name),
                          .doc = std::string(sensor.doc),
                          .type = TypeOf(sensor.type, enumerations),
                          .unit = UnitOf(sensor.unit)};
    for (const robot::Range& range : robot::RangesOf(sensor, robot)) {
      checked.minimum.push_back(range.low);
      checked.maximum.push_back(range.high);
    }
    checked.is_nominal = robot::IsUnlimited(sensor.id);
    checked.is_onboard = sensor.is_onboard;
    catalog.Add(std::move(checked));
  }
  for (const robot::ConstantDescription& constant : robot::Constants()) {
    catalog.Add({.name = std::string(constant.name),
                 .doc = std::string(constant.doc),
                 .type = TypeOf(constant.type, enumerations),
                 .unit = UnitOf(constant.unit),
                 .constant = robot::ValuesOf(constant, robot)});
  }
  return catalog;
}

SensorCatalog SensorCatalog::OfAnyRobot() {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  SensorCatalog catalog;
  for (const robot::SensorDescription& sensor : robot::Sensors()) {
    if (sensor.type.find('[') != std::string_view::npos) {
      catalog.AddInvalid(std::string(sensor.name));
      continue;
    }
    const Type type = TypeOf(sensor.type, {});
    catalog.Add({.name = std::string(sensor.name),
                 .doc = std::string(sensor.doc),
                 .type = type,
                 .unit = ParseUnit(sensor.unit)->unit,
                 .minimum = std::vector<double>(type.size(), -kInfinity),
                 .maximum = std::vector<double>(type.size(), kInfinity)});
  }
  return catalog;
}

void SensorCatalog::AddThings(const world::WorldDescription& world,
                              const std::vector<Enumeration>& enumerations) {
  for (const world::ThingSensor& sensor : world::SensorsOf(world)) {
    const Type type = TypeOf(sensor.type, enumerations);
    const bool is_flag = type.scalar == Scalar::kBool;
    Add({.name = sensor.name,
         .doc = std::string(sensor.doc),
         .type = type,
         .unit = UnitOf(sensor.unit),
         .minimum = std::vector<double>(type.size(), is_flag ? 0 : -sensor.most),
         .maximum = std::vector<double>(type.size(), is_flag ? 1 : sensor.most),
         .is_nominal = !is_flag,
         .is_onboard = false,
         .at_rest = sensor.at_rest});
  }
}

std::vector<std::string> SensorCatalog::Names() const {
  std::vector<std::string> names;
  for (const CheckedSensor& sensor : sensors_) names.push_back(sensor.name);
  return names;
}

std::optional<uint32_t> SensorCatalog::Find(std::string_view name) const {
  for (uint32_t i = 0; i < sensors_.size(); ++i)
    if (sensors_[i].name == name) return i;
  return std::nullopt;
}

bool SensorCatalog::IsInvalid(std::string_view name) const {
  return std::ranges::find(invalid_, name) != invalid_.end();
}

bool SensorCatalog::IsRoot(std::string_view name) const {
  return std::ranges::any_of(
      sensors_, [&](const CheckedSensor& sensor) { return IsFirstPart(name, sensor.name); });
}

bool SensorCatalog::IsInvalidRoot(std::string_view name) const {
  return std::ranges::any_of(invalid_,
                             [&](const std::string& sensor) { return IsFirstPart(name, sensor); });
}

bool IsSensorOfRobots(std::string_view name) {
  return robot::FindSensor(name) != nullptr ||
         std::ranges::find(robot::Constants(), name, &robot::ConstantDescription::name) !=
             robot::Constants().end();
}

std::string ClashWithRobots(std::string_view name) {
  const auto clashes = [name](std::string_view known) {
    return IsFirstPart(name, known) || IsFirstPart(known, name);
  };
  const auto sensor =
      std::ranges::find_if(robot::Sensors(), clashes, &robot::SensorDescription::name);
  if (sensor != robot::Sensors().end()) return std::string(sensor->name);
  const auto constant =
      std::ranges::find_if(robot::Constants(), clashes, &robot::ConstantDescription::name);
  return constant != robot::Constants().end() ? std::string(constant->name) : "";
}

std::string DeclarationOf(std::string_view name) {
  const robot::SensorDescription* sensor = robot::FindSensor(name);
  if (sensor == nullptr || sensor->type.find('[') != std::string_view::npos) return "";
  const std::string unit = sensor->unit.empty() ? "" : fmt::format(" [{}]", sensor->unit);
  return fmt::format("sensor {}: {}{}", sensor->name, sensor->type, unit);
}

}  // namespace compiler
