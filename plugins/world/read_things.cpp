#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "plugins/robot/kind_names.h"
#include "plugins/robot/read_parts.h"
#include "plugins/robot/sensors.h"
#include "plugins/world/ground.h"
#include "plugins/world/read_parts.h"
#include "plugins/world/thing_sensors.h"
#include "plugins/world/world_keys.h"

namespace world {
namespace {

using robot::TomlValue;

constexpr size_t kMostThings = 50;
constexpr double kFarthest = 100;  // from the origin, along each axis [m]

// What robots' sensors are called cannot be a thing's name.
void CheckIsFree(const TomlValue& value, const std::string& name) {
  const auto is_root = [&](std::string_view sensor) {
    return sensor.substr(0, sensor.find('.')) == name;
  };
  const bool is_taken =
      name == kContactWith ||
      std::ranges::any_of(robot::Sensors(), is_root, &robot::SensorDescription::name) ||
      std::ranges::any_of(robot::Constants(), is_root, &robot::ConstantDescription::name);
  if (!is_taken) return;
  value.Fail(fmt::format("a thing cannot be called `{}`: sensors of robots are", name),
             fmt::format("call it otherwise, for example `the_{}`", name));
}

void ReadPlace(const TomlValue& value, const Ground& ground, Thing& thing) {
  const TomlValue position = value.At("position");
  if (const auto orientation = value.Find("orientation"))
    thing.orientation = robot::ReadOrientation(*orientation);
  const std::vector<TomlValue> items = position.Items();
  if (items.size() != 2 && items.size() != 3) {
    position.Fail(fmt::format("{} has {} numbers", position.what(), items.size()),
                  "give [x, y] for a thing that stands on the ground, or [x, y, z] of its center");
  }
  for (const TomlValue& item : items) {
    if (std::abs(item.Number()) > kFarthest)
      item.Fail(fmt::format("{} is far away", position.what()),
                fmt::format("give meters from -{0} to {0}", kFarthest));
  }
  if (items.size() == 3) {
    thing.position = position.ToVector3();
  } else {
    PutDown(ground, items[0].Number(), items[1].Number(), thing.orientation, thing);
  }
}

void ReadMass(const TomlValue& value, Thing& thing) {
  if (const auto fixed = value.Find("fixed")) thing.is_fixed = fixed->Flag();
  if (!thing.is_fixed) {
    thing.mass = value.At("mass").PositiveNumber();
  } else if (const auto mass = value.Find("mass")) {
    mass->Fail(fmt::format("{} is fixed and has no mass", value.what()),
               "leave out `mass`, or `fixed`");
  }
}

constexpr std::array kThingShapes = {robot::ShapeKind::kBox, robot::ShapeKind::kCapsule,
                                     robot::ShapeKind::kCylinder, robot::ShapeKind::kSphere};

Thing ReadThing(const TomlValue& value, std::string name, const Ground& ground) {
  Thing thing;
  thing.name = std::move(name);
  thing.shape.kind = robot::ReadShapeKind(value, kThingShapes);
  value.AllowKeys(KeysOf(robot::NameOf(thing.shape.kind)));
  robot::ReadSize(value, thing.shape);
  ReadMass(value, thing);
  if (const auto friction = value.Find("friction")) thing.friction = friction->NumberNotBelowZero();
  ReadPlace(value, ground, thing);
  return thing;
}

}  // namespace

std::vector<Thing> ReadThings(const TomlValue& root, const Ground& ground) {
  std::vector<Thing> things;
  const auto list = root.Find("things");
  if (!list) return things;
  const std::vector<TomlValue> items = list->Items();
  if (items.size() > kMostThings) {
    list->Fail(
        fmt::format("the world has {} things, and {} is the most", items.size(), kMostThings),
        "make one thing of what stays together");
  }
  for (const TomlValue& value : items) {
    const TomlValue name = value.At("name");
    const std::string text = name.Name();
    robot::CheckIsNew(name, text, "thing", things);
    CheckIsFree(name, text);
    things.push_back(ReadThing(value.Called(fmt::format("thing `{}`", text)), text, ground));
  }
  return things;
}

}  // namespace world
