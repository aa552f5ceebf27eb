#include "compiler/driver/task_skeleton.h"

#include <algorithm>
#include <vector>

#include "plugins/robot/sensors.h"

namespace compiler {
namespace {

constexpr size_t kWidth = 98;

// "// Links: body, head, ..." over as many lines as it takes.
std::string Listed(const std::string& what, const std::vector<std::string>& names) {
  std::string text;
  std::string line = "// " + what + ":";
  for (const std::string& name : names) {
    const std::string word = " " + name + (&name == &names.back() ? "" : ",");
    if (line.size() + word.size() > kWidth) {
      text += line + "\n";
      line = "//  ";
    }
    line += word;
  }
  return text + line + "\n";
}

template <typename Part>
std::vector<std::string> NamesOf(const std::vector<Part>& parts) {
  std::vector<std::string> names;
  for (const Part& part : parts) names.push_back(part.name);
  return names;
}

std::vector<std::string> SensorNames(const robot::RobotDescription& robot) {
  std::vector<std::string> names;
  const auto add = [&names](const auto& sensor) {
    std::string name(sensor.name);
    name += ": " + std::string(sensor.type);
    if (!sensor.unit.empty()) name += " [" + std::string(sensor.unit) + "]";
    names.push_back(name);
  };
  std::ranges::for_each(robot::SensorsOf(robot), add);
  std::ranges::for_each(robot::Constants(), add);
  return names;
}

std::string ForRobot(const std::string& name, const robot::RobotDescription& robot) {
  std::string text = "/// What the robot should do, in one sentence.\ntask " + name + " for " +
                     robot.name + "\n\n";
  if (!robot.poses.empty()) {
    text += Listed("Poses to start from", NamesOf(robot.poses));
    text += "start " + robot.poses.front().name + "\n\n";
  }
  text += Listed("Sensors", SensorNames(robot));
  text += Listed("Links", NamesOf(robot.links));
  if (!robot.link_groups.empty()) text += Listed("Groups of links", NamesOf(robot.link_groups));
  text += Listed("Joints", NamesOf(robot.joints));
  if (!robot.joint_groups.empty()) text += Listed("Groups of joints", NamesOf(robot.joint_groups));
  if (!robot.sites.empty()) text += Listed("Sites", NamesOf(robot.sites));
  if (!robot.site_groups.empty()) text += Listed("Groups of sites", NamesOf(robot.site_groups));
  return text +
         "\n"
         "/// What a fall costs. A param can be changed while the trainer runs.\n"
         "param fall_penalty: real = 2 in 0 .. 20\n"
         "\n"
         "/// What you really want, apart from the reward: plotted next to the return.\n"
         "metric distance = base.position.x\n"
         "\n"
         "on end_of_time_step {\n"
         "  // A rate is paid per second, whatever the length of the time step.\n"
         "  reward rate forward = 10 * base.velocity.x\n"
         "\n"
         "  if contact[" +
         robot.links.front().name +
         "] {\n"
         "    // After an end nothing else is paid: a fall costs this once.\n"
         "    reward fall = -fall_penalty\n"
         "    end_episode failure \"falls\"\n"
         "  }\n"
         "  if time > 20 s { truncate_episode \"time is up\" }\n"
         "}\n"
         "\n"
         "// `taskc test` runs this, without a simulation.\n"
         "test \"a fall is paid once and ends the episode\" {\n"
         "  given contact[" +
         robot.links.front().name +
         "] = true\n"
         "  fire 3 * end_of_time_step\n"
         "  expect total(fall) == -fall_penalty\n"
         "  expect end_episode failure \"falls\"\n"
         "}\n";
}

std::string WithOwnSensors(const std::string& name) {
  return "/// What should be learned, in one sentence.\n"
         "task " +
         name +
         "\n"
         "\n"
         "// The program that runs this task supplies these sensors by name, type and unit.\n"
         "sensor time: real [s]\n"
         "sensor position: vec3 [m]\n"
         "sensor velocity: vec3 [m/s]\n"
         "\n"
         "/// How far the field extends to each side. A param can be changed while the trainer "
         "runs.\n"
         "param width: real [m] = 2 m in 0.5 m .. 10 m\n"
         "\n"
         "/// What you really want, apart from the reward: plotted next to the return.\n"
         "metric distance = position.x\n"
         "\n"
         "on end_of_time_step {\n"
         "  // A rate is paid per second, whatever the length of the time step.\n"
         "  reward rate forward = 10 * velocity.x\n"
         "\n"
         "  if abs(position.y) > width { end_episode failure \"leaves the field\" }\n"
         "  if time > 20 s { truncate_episode \"time is up\" }\n"
         "}\n";
}

}  // namespace

std::string TaskSkeleton(const std::string& name, const robot::RobotDescription* robot) {
  return robot != nullptr ? ForRobot(name, *robot) : WithOwnSensors(name);
}

}  // namespace compiler
