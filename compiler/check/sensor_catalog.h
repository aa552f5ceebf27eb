// The sensors that a task may read: those of its robot, or those that it declares itself.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/check/enumeration.h"
#include "plugins/robot/robot_description.h"
#include "plugins/world/world_description.h"

namespace compiler {

class SensorCatalog {
 public:
  // The sensors and constants of plugins/robot/sensors.h, as this robot has them; `enumerations`
  // are its own.
  static SensorCatalog OfRobot(const robot::RobotDescription& robot,
                               const std::vector<Enumeration>& enumerations);

  // Those that robots have. One with an element for each link, joint or site counts as wrongly
  // declared: how many these are is not known.
  static SensorCatalog OfAnyRobot();

  // Those of a world's things.
  void AddThings(const world::WorldDescription& world,
                 const std::vector<Enumeration>& enumerations);

  void Add(CheckedSensor sensor) { sensors_.push_back(std::move(sensor)); }
  // A sensor whose declaration is wrong: what reads it is not to be reported.
  void AddInvalid(std::string name) { invalid_.push_back(std::move(name)); }

  const std::vector<CheckedSensor>& list() const { return sensors_; }
  std::vector<std::string> Names() const;
  std::optional<uint32_t> Find(std::string_view name) const;
  bool IsInvalid(std::string_view name) const;
  // Is `name` the first part of a sensor's name, as `base` is of `base.velocity`?
  bool IsRoot(std::string_view name) const;
  // The same for the sensors that are wrongly declared.
  bool IsInvalidRoot(std::string_view name) const;

 private:
  std::vector<CheckedSensor> sensors_;
  std::vector<std::string> invalid_;
};

// Do robots have a sensor, or a constant, called `name`?
bool IsSensorOfRobots(std::string_view name);

// The sensor or constant of robots that has this name, or whose name begins with it or it with
// that; empty where there is none.
std::string ClashWithRobots(std::string_view name);

// How a task without a robot declares the sensor that robots call `name`: "sensor base.velocity:
// vec3 [m/s]". Empty where its type needs a robot.
std::string DeclarationOf(std::string_view name);

}  // namespace compiler
