// The parts of a world file, each read and checked by one function. All throw
// robot::DescriptionError.
#pragma once

#include "plugins/robot/toml_value.h"
#include "plugins/world/world_description.h"

namespace world {

// `root`: the whole file, called `file`.
Ground ReadGround(const robot::TomlValue& root, const std::filesystem::path& file,
                  const ReadFile& read);
// `ground`: what they stand on.
std::vector<Thing> ReadThings(const robot::TomlValue& root, const Ground& ground);

}  // namespace world
