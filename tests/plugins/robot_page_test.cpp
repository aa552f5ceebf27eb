// docs/robots.md explains the keys that the reader accepts, and no others.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "plugins/robot/reserved_words.h"
#include "plugins/robot/robot_keys.h"

namespace robot {
namespace {

using Sections = std::map<std::string, std::set<std::string>>;

// The first column of the tables of each section whose heading is a word of code.
Sections KeysOfThePage() {
  Sections sections;
  std::ifstream page(ROBOTS_PAGE);
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

TEST(RobotPage, HasTheKeysOfTheReaderAndNoOthers) {
  Sections accepted;
  for (const KeyTable& table : KeyTables()) {
    accepted[std::string(table.section)].insert(table.keys.begin(), table.keys.end());
  }
  EXPECT_EQ(KeysOfThePage(), accepted);
}

// The column `of` says which kinds of tables have the key; `all` is each of them.
TEST(RobotPage, SaysWhichKindsHaveAKey) {
  std::ifstream page(ROBOTS_PAGE);
  std::string section;
  int rows = 0;
  bool has_kinds = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("## `")) section = line.substr(4, line.size() - 5);
    if (line.starts_with("| key |")) has_kinds = line.starts_with("| key | of |");
    if (line.empty()) has_kinds = false;
    if (!has_kinds || !line.starts_with("| `")) continue;
    ++rows;
    const std::string key = line.substr(3, line.find('`', 3) - 3);
    const size_t column = line.find("| ", 2) + 2;
    const std::string kinds = line.substr(column, line.find(" |", column) - column);
    for (const KeyTable& table : KeyTables()) {
      if (table.section != section) continue;
      const bool has_key = std::ranges::find(table.keys, key) != table.keys.end();
      const bool is_said = kinds == "all" || kinds.find(table.kind) != std::string::npos;
      EXPECT_EQ(has_key, is_said) << key << " of " << table.kind;
    }
  }
  EXPECT_GT(rows, 20);
}

// What docs/language.md says of the words that are nobody's name.
TEST(ReservedWords, AreThoseOfTheLanguagesPage) {
  std::stringstream page;
  page << std::ifstream(LANGUAGE_PAGE).rdbuf();
  const std::string text = page.str();
  const size_t begin = text.find("These words are reserved:");
  ASSERT_NE(begin, std::string::npos);
  const std::string list = text.substr(begin, text.find("(`min`", begin) - begin);
  std::set<std::string> words;
  for (size_t i = list.find('`'); i != std::string::npos; i = list.find('`', i)) {
    const size_t end = list.find('`', i + 1);
    words.insert(list.substr(i + 1, end - i - 1));
    i = end + 1;
  }
  EXPECT_EQ(words.size(), 37u);
  for (const std::string& word : words) EXPECT_TRUE(IsReservedWord(word)) << word;
  for (const char* word : {"min", "phase", "unit", "left_knee", "M"}) {
    EXPECT_EQ(IsReservedWord(word), words.contains(word)) << word;
  }
}

}  // namespace
}  // namespace robot
