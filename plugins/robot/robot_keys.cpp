#include "plugins/robot/robot_keys.h"

#include <algorithm>
#include <cassert>

namespace robot {
namespace {

using Keys = std::vector<std::string_view>;

Keys operator+(Keys first, const Keys& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

std::vector<KeyTable> MakeKeyTables() {
  const Keys link = {"name",     "shape",          "mass",
                     "position", "shape_position", "shape_orientation",
                     "inertia",  "friction"};
  const Keys connection = {"name", "type", "parent", "child"};
  const Keys gains = {"stiffness", "damping", "max_torque", "max_speed"};
  const Keys driven = connection + Keys{"axis"} + gains +
                      Keys{"passive", "spring", "spring_rest", "damper", "friction", "armature"};
  return {
      {"robot",
       "robot",
       {"name", "doc", "base", "links", "joints", "sites", "controller", "poses", "link_groups",
        "joint_groups", "site_groups", "dof_configurations", "nets", "ranges",
        "contact_exclusions"}},
      {"links", "box", link + Keys{"size"}},
      {"links", "capsule", link + Keys{"axis", "radius", "length"}},
      {"links", "cylinder", link + Keys{"axis", "radius", "length"}},
      {"links", "sphere", link + Keys{"radius"}},
      {"links", "convex", link + Keys{"points"}},
      {"joints", "hinge", driven + Keys{"anchor", "stops_deg"}},
      {"joints", "continuous", driven + Keys{"anchor"}},
      {"joints", "slider", driven + Keys{"travel", "radius"}},
      {"joints", "fixed", connection},
      {"joints", "ball", connection + Keys{"anchor", "damper"}},
      {"sites", "site", {"name", "link", "position", "orientation"}},
      {"controller", "controller", gains + Keys{"time_step"}},
      {"poses", "pose", {"name", "position", "orientation", "joints"}},
      {"dof_configurations", "DoF configuration", {"name", "coordinates"}},
      {"dof_configurations", "coordinate", {"joint", "also"}},
      {"nets", "grid", {"name", "dof", "kind", "counts", "low", "high", "deviations"}},
      {"nets", "bubble", {"name", "dof", "kind", "units", "low", "high"}},
  };
}

}  // namespace

std::span<const KeyTable> KeyTables() {
  static const std::vector<KeyTable> tables = MakeKeyTables();
  return tables;
}

const std::vector<std::string_view>& KeysOf(std::string_view kind,
                                            std::span<const KeyTable> tables) {
  const auto found = std::ranges::find(tables, kind, &KeyTable::kind);
  assert(found != tables.end());
  return found->keys;
}

}  // namespace robot
