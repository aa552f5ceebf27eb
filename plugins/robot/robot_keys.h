// The keys of a robot's file: what the reader accepts and docs/robots.md explains.
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace robot {

struct KeyTable {
  std::string_view section;  // of the page, in which all keys of this kind of table stand
  std::string_view kind;     // "hinge": of which joints; the section itself where there is one kind
  std::vector<std::string_view> keys;
};

std::span<const KeyTable> KeyTables();

// Precondition: there is such a kind of table in `tables`.
const std::vector<std::string_view>& KeysOf(std::string_view kind,
                                            std::span<const KeyTable> tables = KeyTables());

}  // namespace robot
