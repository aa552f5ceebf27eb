// The keys of a world's file: what the reader accepts and docs/worlds.md explains.
#pragma once

#include <span>

#include "plugins/robot/robot_keys.h"

namespace world {

std::span<const robot::KeyTable> KeyTables();

// Precondition: there is such a kind of table.
const std::vector<std::string_view>& KeysOf(std::string_view kind);

}  // namespace world
