// The robot's parts as a task names them: its links, joints and sites, and named groups of them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plugins/robot/robot_description.h"

namespace compiler {

struct Enumeration {
  std::string name;                  // "link", as in `bool[link]`
  std::string all;                   // "links": the group of all members
  std::vector<std::string> members;  // by index
  std::vector<robot::Group> groups;  // without the group of all members

  uint32_t size() const { return static_cast<uint32_t>(members.size()); }
  // The indices that `part` stands for: one for a member, several for a group.
  std::optional<std::vector<uint32_t>> Find(std::string_view part) const;
  // Members, groups, and the group of all.
  std::vector<std::string> Names() const;
};

// `link`, `joint`, and `site` where it has sites; none where there is no robot.
std::vector<Enumeration> EnumerationsOf(const robot::RobotDescription* robot);

// The enumeration called `name`, or null.
const Enumeration* FindEnumeration(const std::vector<Enumeration>& enumerations,
                                   std::string_view name);
// The enumeration that has a member or group called `part`, or null.
const Enumeration* FindEnumerationOf(const std::vector<Enumeration>& enumerations,
                                     std::string_view part);

}  // namespace compiler
