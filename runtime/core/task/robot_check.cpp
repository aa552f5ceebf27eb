#include "runtime/core/task/robot_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plugins/robot/sensors.h"
#include "runtime/base/suggestion.h"
#include "runtime/base/user_error.h"
#include "runtime/core/module/sensor_data.h"
#include "runtime/core/module/sensor_type.h"
#include "runtime/core/task/task_world.h"

namespace runtime {
namespace {

// Names the task's own file: the plugin may be one that the trainer has just built somewhere.
[[noreturn]] void Refuse(const Plugin& plugin, const std::string& reason) {
  throw UserError(fmt::format("{}: {}", plugin.table().sources[0].file, reason));
}

// A task that is written for no robot in particular knows the number of joints, not their names:
// "real[17]" for "real[joint]".
std::string TypeWithCount(const robot::SensorDescription& sensor,
                          const robot::RobotDescription& robot) {
  const std::string_view type = sensor.type;
  const size_t bracket = type.find('[');
  if (bracket == std::string_view::npos) return std::string(type);
  const std::string_view index = type.substr(bracket + 1, type.size() - bracket - 2);
  return fmt::format("{}[{}]", type.substr(0, bracket), *robot::EntryCount(index, robot));
}

// The module that offers a sensor of this type has as many elements.
void CheckOwnSensor(const Plugin& plugin, const taskc_sensor& sensor,
                    const robot::RobotDescription& robot) {
  const std::string_view type = sensor.type;
  const taskc_int32 scalar = type.starts_with("bool")  ? TASKC_BOOL
                             : type.starts_with("int") ? TASKC_INT
                                                       : TASKC_REAL;
  const size_t elements = size_t{sensor.rows} * sensor.columns;
  if (scalar == sensor.scalar && ElementsOfType(type, robot) == elements) return;
  Refuse(plugin, fmt::format("the task was built for another `{}`: its sensor `{}` has {} "
                             "elements, which no `{}` has; build it again with `taskc build`",
                             robot.name, sensor.name, elements, type));
}

// One that no robot has comes from another module.
void CheckSensor(const Plugin& plugin, const taskc_sensor& wanted,
                 const robot::RobotDescription& robot) {
  const robot::SensorDescription* known = robot::FindSensor(wanted.name);
  if (known == nullptr || robot.name.empty()) return CheckOwnSensor(plugin, wanted, robot);
  const robot::SensorDescription& offered = *known;
  const int count = robot::ElementCount(offered, robot);
  const bool same_type =
      offered.type == wanted.type || TypeWithCount(offered, robot) == wanted.type;
  if (!same_type || offered.unit != wanted.unit) {
    Refuse(plugin,
           fmt::format("the task reads the sensor `{}` as `{}`, and the robot `{}` gives `{}`: "
                       "correct the task, and build it again with `taskc build`",
                       wanted.name, SensorTypeText(wanted.type, wanted.unit), robot.name,
                       SensorTypeText(offered.type, offered.unit)));
  }
  const bool same_scalar = (wanted.scalar == TASKC_BOOL) == offered.type.starts_with("bool") &&
                           wanted.scalar != TASKC_INT;
  if (!same_scalar || wanted.rows * wanted.columns != static_cast<uint32_t>(count)) {
    Refuse(plugin,
           fmt::format("the task was built for another `{}`: its sensor `{}` has {} elements, "
                       "this robot's has {}; build it again with `taskc build`",
                       robot.name, wanted.name, wanted.rows * wanted.columns, count));
  }
}

// Arrays have their entries in the order of these.
template <class Part>
void CheckParts(const Plugin& plugin, std::span<const taskc_part> wanted,
                const std::vector<Part>& parts, std::string_view what,
                const robot::RobotDescription& robot) {
  const auto same = [](const taskc_part& a, const Part& b) { return a.name == b.name; };
  if (wanted.empty() || std::ranges::equal(wanted, parts, same)) return;
  Refuse(plugin, fmt::format("the task was built for another `{}`, with other {} or in another "
                             "order; build it again with `taskc build`",
                             robot.name, what));
}

void CheckPose(const Plugin& plugin, const char* pose, const robot::RobotDescription& robot) {
  if (robot.FindPose(pose) != nullptr) return;
  std::vector<std::string> names;
  for (const robot::Pose& each : robot.poses) names.push_back(each.name);
  Refuse(plugin,
         fmt::format("the task starts in the pose `{}`, which the robot `{}` does not have{}", pose,
                     robot.name, Suggestion(pose, names)));
}

void CheckStartValue(const Plugin& plugin, const taskc_start_value& value,
                     const robot::RobotDescription& robot) {
  const std::string_view name = value.name;
  const bool is_angle = name == "base.roll" || name == "base.pitch" || name == "base.yaw";
  const size_t count = name.starts_with("joint.") ? robot.joints.size() : is_angle ? 1 : 3;
  if (value.rows == count) return;
  Refuse(plugin,
         fmt::format("the task was built for another `{}`: its start has {} elements of `{}`, this "
                     "robot's has {}; build it again with `taskc build`",
                     robot.name, value.rows, name, count));
}

}  // namespace

void CheckFitsRobot(const Plugin& plugin, const robot::RobotDescription& robot) {
  const taskc_plugin& table = plugin.table();
  const std::string_view wanted_robot = table.robot;
  if (!wanted_robot.empty() && robot.name.empty()) {
    Refuse(plugin, fmt::format("the task `{}` is for the robot `{}`, and this run has no robot",
                               table.name, wanted_robot));
  }
  if (!wanted_robot.empty() && wanted_robot != robot.name) {
    Refuse(plugin,
           fmt::format("the task `{}` is for the robot `{}`, and this run has the robot `{}`",
                       table.name, wanted_robot, robot.name));
  }
  for (uint32_t i = 0; i < table.pose_count; ++i) CheckPose(plugin, table.poses[i].name, robot);
  for (uint32_t i = 0; i < table.start_value_count; ++i) {
    CheckStartValue(plugin, table.start_values[i], robot);
  }
  for (uint32_t i = 0; i < table.sensor_count; ++i) CheckSensor(plugin, table.sensors[i], robot);
  // Last: another number of them has been said of the sensor that it matters to.
  CheckParts(plugin, {table.links, table.link_count}, robot.links, "links", robot);
  CheckParts(plugin, {table.joints, table.joint_count}, robot.joints, "joints", robot);
  CheckParts(plugin, {table.sites, table.site_count}, robot.sites, "sites", robot);
}

void CheckFitsWorld(const Plugin& plugin, const Plugin& first) {
  const std::unique_ptr<const world::WorldDescription> wanted = WorldOf(plugin.table());
  if (wanted == nullptr) return;
  const std::unique_ptr<const world::WorldDescription> present = WorldOf(first.table());
  if (present != nullptr && *wanted == *present) return;
  Refuse(plugin,
         fmt::format("the task `{}` is in a world, and this run is {}: start another run "
                     "with it",
                     plugin.table().name, present == nullptr ? "in none" : "in another one"));
}

}  // namespace runtime
