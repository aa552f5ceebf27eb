#include <tuple>

#include "plugins/world/read_parts.h"
#include "plugins/world/world_keys.h"

namespace world {

bool Thing::operator==(const Thing& other) const {
  const auto parts = [](const Thing& thing) {
    return std::tie(thing.name, thing.shape.kind, thing.shape.size, thing.shape.radius,
                    thing.shape.length, thing.shape.axis, thing.is_fixed, thing.mass,
                    thing.friction, thing.position, thing.orientation);
  };
  return parts(*this) == parts(other);
}

WorldDescription ReadWorld(std::string_view text, const std::filesystem::path& file,
                           const ReadFile& read) {
  const std::string name = file.string();
  const toml::table table = robot::ParseToml(text, name);
  const robot::TomlValue root(name, table, "the world");
  root.AllowKeys(KeysOf("world"));
  WorldDescription world;
  if (const auto doc = root.Find("doc")) world.doc = doc->Text();
  world.ground = ReadGround(root, file, read);
  world.things = ReadThings(root, world.ground);
  return world;
}

}  // namespace world
