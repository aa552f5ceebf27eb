// The parts of a robot description, each read and checked by one function. `root` is the whole
// file; `robot` holds the parts read before. All throw DescriptionError.
#pragma once

#include <fmt/format.h>

#include <array>
#include <span>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "plugins/robot/robot_keys.h"
#include "plugins/robot/toml_value.h"

namespace robot {

inline constexpr std::array kShapeKinds = {ShapeKind::kBox, ShapeKind::kCapsule,
                                           ShapeKind::kCylinder, ShapeKind::kSphere,
                                           ShapeKind::kConvex};

std::vector<Link> ReadLinks(const TomlValue& root);
// What `shape` of a link, or of another solid part, says; one of `kinds`.
ShapeKind ReadShapeKind(const TomlValue& part, std::span<const ShapeKind> kinds);
// Sets the lengths, or the points, of a shape of this kind.
void ReadSize(const TomlValue& part, LinkShape& shape);
// Of a link; `center`: its center of mass.
LinkShape ReadShape(const TomlValue& link, const Vector3& center);
std::vector<std::array<int, 2>> ReadContactExclusions(const TomlValue& root,
                                                      const RobotDescription& robot);
// A unit quaternion, w, x, y, z.
Quaternion ReadOrientation(const TomlValue& value);
// Sets `joints` and `mounts` of `robot`.
void ReadJoints(const TomlValue& root, RobotDescription& robot);
std::vector<Site> ReadSites(const TomlValue& root, const RobotDescription& robot);
std::vector<Pose> ReadPoses(const TomlValue& root, const RobotDescription& robot);
// `key`: "link_groups"; `kind`: "link"; `names`: those of all links.
std::vector<Group> ReadGroups(const TomlValue& root, std::string_view key, std::string_view kind,
                              const std::vector<std::string>& names);
std::vector<DofConfiguration> ReadDofConfigurations(const TomlValue& root,
                                                    const RobotDescription& robot);
std::vector<NetDescription> ReadNets(const TomlValue& root, const RobotDescription& robot);
std::vector<NominalRange> ReadNominalRanges(const TomlValue& root, const RobotDescription& robot);

// The names of links, joints, poses, ...
template <class Part>
std::vector<std::string> NamesOf(const std::vector<Part>& parts) {
  std::vector<std::string> names;
  for (const Part& part : parts) names.push_back(part.name);
  return names;
}

// Throws if `parts` has one with this name already.
template <class Part>
void CheckIsNew(const TomlValue& value, const std::string& name, std::string_view kind,
                const std::vector<Part>& parts) {
  for (const Part& part : parts) {
    if (part.name != name) continue;
    value.Fail(fmt::format("a second {} is called `{}`", kind, name), "rename one of the two");
  }
}

}  // namespace robot
