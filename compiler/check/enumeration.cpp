#include "compiler/check/enumeration.h"

#include <numeric>

namespace compiler {

std::optional<std::vector<uint32_t>> Enumeration::Find(std::string_view part) const {
  if (part == all) {
    std::vector<uint32_t> indices(members.size());
    std::iota(indices.begin(), indices.end(), 0);
    return indices;
  }
  for (uint32_t i = 0; i < size(); ++i)
    if (members[i] == part) return std::vector<uint32_t>{i};
  for (const robot::Group& group : groups)
    if (group.name == part)
      return std::vector<uint32_t>(group.members.begin(), group.members.end());
  return std::nullopt;
}

std::vector<std::string> Enumeration::Names() const {
  std::vector<std::string> names = members;
  for (const robot::Group& group : groups) names.push_back(group.name);
  names.push_back(all);
  return names;
}

namespace {

template <class Part>
Enumeration EnumerationOf(const char* name, const std::vector<Part>& parts,
                          const std::vector<robot::Group>& groups) {
  Enumeration enumeration{name, std::string(name) + "s", {}, groups};
  for (const Part& part : parts) enumeration.members.push_back(part.name);
  return enumeration;
}

}  // namespace

std::vector<Enumeration> EnumerationsOf(const robot::RobotDescription* robot) {
  if (robot == nullptr) return {};
  std::vector<Enumeration> enumerations = {
      EnumerationOf("link", robot->links, robot->link_groups),
      EnumerationOf("joint", robot->joints, robot->joint_groups)};
  if (!robot->sites.empty())
    enumerations.push_back(EnumerationOf("site", robot->sites, robot->site_groups));
  return enumerations;
}

const Enumeration* FindEnumeration(const std::vector<Enumeration>& enumerations,
                                   std::string_view name) {
  for (const Enumeration& enumeration : enumerations)
    if (enumeration.name == name) return &enumeration;
  return nullptr;
}

const Enumeration* FindEnumerationOf(const std::vector<Enumeration>& enumerations,
                                     std::string_view part) {
  for (const Enumeration& enumeration : enumerations)
    if (enumeration.Find(part)) return &enumeration;
  return nullptr;
}

}  // namespace compiler
