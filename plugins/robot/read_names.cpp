#include <algorithm>
#include <cmath>

#include "plugins/robot/read_parts.h"

namespace robot {
namespace {

void ReadJointAngles(const TomlValue& value, const RobotDescription& robot, Pose& pose) {
  // Room for the last digit of angles that were measured at a stop.
  constexpr double kTolerance = 1e-6;
  for (const auto& [name, angle] : value.Entries()) {
    const std::optional<int> index = robot.FindJoint(name);
    if (!index) {
      angle.Fail(fmt::format("there is no joint `{}`", name),
                 SuggestName(name, NamesOf(robot.joints)));
    }
    const Joint& joint = robot.joints[*index];
    const double number = angle.Number();
    if (number < joint.low - kTolerance || number > joint.high + kTolerance) {
      angle.Fail(fmt::format("pose `{}` turns joint `{}` beyond its stops", pose.name, name),
                 fmt::format("give an angle in rad from {:.4f} to {:.4f}", joint.low, joint.high));
    }
    pose.joint_angles[*index] = number;
  }
}

// Adds the link, or the group above, that `value` names.
void AddMembers(const TomlValue& value, const std::vector<std::string>& names,
                std::string_view kind, const std::vector<Group>& groups, Group& group) {
  const std::string name = value.Text();
  for (const Group& other : groups) {
    if (other.name != name) continue;
    group.members.insert(group.members.end(), other.members.begin(), other.members.end());
    return;
  }
  std::vector<std::string> choices = names;
  for (const Group& other : groups) choices.push_back(other.name);
  group.members.push_back(value.IndexIn(choices, kind));
}

}  // namespace

Quaternion ReadOrientation(const TomlValue& value) {
  const std::vector<double> numbers = value.Numbers(4);
  double square = 0;
  for (double number : numbers) square += number * number;
  if (std::abs(square - 1) > 1e-2) {
    value.Fail(value.what() + " is not a unit quaternion", "give w, x, y, z with a norm of 1");
  }
  Quaternion orientation;
  for (int i = 0; i < 4; ++i) orientation[i] = numbers[i] / std::sqrt(square);
  return orientation;
}

std::vector<Pose> ReadPoses(const TomlValue& root, const RobotDescription& robot) {
  std::vector<Pose> poses;
  const TomlValue list = root.At("poses");
  for (const TomlValue& value : list.Items()) {
    value.AllowKeys(KeysOf("pose"));
    Pose pose;
    const TomlValue name = value.At("name");
    pose.name = name.Name();
    CheckIsNew(name, pose.name, "pose", poses);
    const TomlValue named = value.Called(fmt::format("pose `{}`", pose.name));
    pose.position = named.At("position").ToVector3();
    if (const auto orientation = named.Find("orientation")) {
      pose.orientation = ReadOrientation(*orientation);
    }
    pose.joint_angles.assign(robot.joints.size(), 0.0);
    if (const auto joints = named.Find("joints")) ReadJointAngles(*joints, robot, pose);
    poses.push_back(std::move(pose));
  }
  if (poses.empty())
    list.Fail("the robot has no pose", "describe the one that episodes start from");
  return poses;
}

std::vector<Group> ReadGroups(const TomlValue& root, std::string_view key, std::string_view kind,
                              const std::vector<std::string>& names) {
  std::vector<Group> groups;
  const auto table = root.Find(key);
  if (!table) return groups;
  for (const auto& [name, value] : table->Called(fmt::format("`{}`", key)).Entries()) {
    value.CheckIsName(name);
    const std::string all = fmt::format("{}s", kind);
    if (name == all || std::find(names.begin(), names.end(), name) != names.end()) {
      value.Fail(fmt::format("group `{}` has the name of {}", name,
                             name == all ? fmt::format("the group of all {}", all)
                                         : fmt::format("a {}", kind)),
                 "rename the group");
    }
    Group group{name, {}};
    for (const TomlValue& member : value.Items()) {
      AddMembers(member, names, kind, groups, group);
    }
    if (group.members.empty()) value.Fail(fmt::format("group `{}` is empty", name), "add a member");
    std::sort(group.members.begin(), group.members.end());
    group.members.erase(std::unique(group.members.begin(), group.members.end()),
                        group.members.end());
    groups.push_back(std::move(group));
  }
  return groups;
}

}  // namespace robot
