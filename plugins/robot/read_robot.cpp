#include "base/file/read.h"
#include "plugins/robot/read_parts.h"

namespace robot {
namespace {

toml::table Parse(const std::string& file) {
  const file::Reading reading = file::Read(file);
  if (!reading.problem.empty()) {
    throw DescriptionError(
        fmt::format("{}: error: cannot read the robot's description: {}\n  help: check that the "
                    "file is there and may be read",
                    file, reading.problem));
  }
  return ParseToml(reading.bytes, file);
}

Controller ReadController(const TomlValue& root) {
  const TomlValue value = root.At("controller").Called("`controller`");
  value.AllowKeys(KeysOf("controller"));
  Controller controller;
  controller.stiffness = value.At("stiffness").PositiveNumber();
  controller.damping = value.At("damping").PositiveNumber();
  controller.max_torque = value.At("max_torque").PositiveNumber();
  if (const auto max_speed = value.Find("max_speed"))
    controller.max_speed = max_speed->PositiveNumber();
  controller.time_step = value.At("time_step").PositiveNumber();
  return controller;
}

// `called`: its folder's name, or nothing where any name will do.
std::string ReadName(const TomlValue& root, std::optional<std::string_view> called) {
  const TomlValue value = root.At("name");
  std::string name = value.Name();
  if (called && *called != name) {
    value.Fail(fmt::format("the robot in the folder `{}` is called `{}`", *called, name),
               fmt::format("write `name = \"{}\"`, or rename the folder", *called));
  }
  return name;
}

RobotDescription Read(const std::filesystem::path& file, std::optional<std::string_view> called) {
  const std::string file_name = file.string();
  const toml::table table = Parse(file_name);
  const TomlValue root(file_name, table, "the robot");
  root.AllowKeys(KeysOf("robot"));
  RobotDescription robot;
  robot.file = file;
  robot.name = ReadName(root, called);
  robot.doc = root.At("doc").Text();
  robot.links = ReadLinks(root);
  if (const auto base = root.Find("base"))
    robot.has_fixed_base = base->IndexIn({"free", "fixed"}, "kind of base") == 1;
  ReadJoints(root, robot);
  robot.sites = ReadSites(root, robot);
  robot.contact_exclusions = ReadContactExclusions(root, robot);
  robot.controller = ReadController(root);
  robot.poses = ReadPoses(root, robot);
  robot.link_groups = ReadGroups(root, "link_groups", "link", NamesOf(robot.links));
  robot.joint_groups = ReadGroups(root, "joint_groups", "joint", NamesOf(robot.joints));
  robot.site_groups = ReadGroups(root, "site_groups", "site", NamesOf(robot.sites));
  robot.dof_configurations = ReadDofConfigurations(root, robot);
  robot.nets = ReadNets(root, robot);
  robot.nominal_ranges = ReadNominalRanges(root, robot);
  return robot;
}

}  // namespace

RobotDescription ReadRobot(const std::filesystem::path& file) { return Read(file, std::nullopt); }

RobotDescription ReadRobotCalled(std::string_view name, const std::filesystem::path& file) {
  return Read(file, name);
}

}  // namespace robot
