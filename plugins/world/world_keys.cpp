#include "plugins/world/world_keys.h"

namespace world {
namespace {

using Keys = std::vector<std::string_view>;

Keys With(Keys first, const Keys& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

std::vector<robot::KeyTable> MakeKeyTables() {
  const Keys ground = {"kind", "friction"};
  const Keys thing = {"name", "shape", "mass", "fixed", "friction", "position", "orientation"};
  return {
      {"world", "world", {"doc", "ground", "things"}},
      {"ground", "plane", ground},
      {"ground", "slope", With(ground, {"angle_deg", "direction_deg"})},
      {"ground", "steps", With(ground, {"start", "depth", "height", "count"})},
      {"ground", "heightmap", With(ground, {"file", "size", "center", "height"})},
      {"things", "box", With(thing, {"size"})},
      {"things", "capsule", With(thing, {"axis", "radius", "length"})},
      {"things", "cylinder", With(thing, {"axis", "radius", "length"})},
      {"things", "sphere", With(thing, {"radius"})},
  };
}

}  // namespace

std::span<const robot::KeyTable> KeyTables() {
  static const std::vector<robot::KeyTable> tables = MakeKeyTables();
  return tables;
}

const std::vector<std::string_view>& KeysOf(std::string_view kind) {
  return robot::KeysOf(kind, KeyTables());
}

}  // namespace world
