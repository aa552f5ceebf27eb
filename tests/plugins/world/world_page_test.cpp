// docs/worlds.md explains the keys that the reader accepts, and no others.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <set>
#include <string>

#include "plugins/world/world_keys.h"

namespace world {
namespace {

using Sections = std::map<std::string, std::set<std::string>>;

// The first column of the tables of each section whose heading is a word of code.
Sections KeysOfThePage() {
  Sections sections;
  std::ifstream page(WORLDS_PAGE);
  std::string section;
  bool is_of_keys = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("## "))
      section = line.starts_with("## `") ? line.substr(4, line.size() - 5) : "";
    if (line.empty()) is_of_keys = false;
    if (line.starts_with("| key |")) is_of_keys = true;
    if (!is_of_keys || section.empty() || !line.starts_with("| `")) continue;
    sections[section].insert(line.substr(3, line.find('`', 3) - 3));
  }
  return sections;
}

TEST(WorldPage, HasTheKeysOfTheReaderAndNoOthers) {
  Sections accepted;
  for (const robot::KeyTable& table : KeyTables()) {
    accepted[std::string(table.section)].insert(table.keys.begin(), table.keys.end());
  }
  EXPECT_EQ(KeysOfThePage(), accepted);
}

}  // namespace
}  // namespace world
