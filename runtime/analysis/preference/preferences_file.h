// What a user prefers: preferences.toml in the folder of the runs,
//
//   [[preference]]
//   better = "crawling-fast-tree/seed3"
//   worse = "crawling-fast-tree/seed1"
//
//   [[preference]]
//   equal = ["crawling-fast-tree/seed2", "crawling-fast-tree/seed7:1200"]
//
// All functions throw UserError, with the place of a mistake in the file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace runtime {

inline constexpr const char* kPreferencesFile = "preferences.toml";

// What a robot does at the end of a run, or in one of its episodes: "seed7", "seed7:1200".
struct BehaviorName {
  std::string run;  // name of its folder, as seen from that of all runs
  std::optional<int64_t> episode;

  std::string text() const;
  auto operator<=>(const BehaviorName&) const = default;
};

BehaviorName ParseBehaviorName(std::string_view text);

// One statement of the user about two behaviors.
struct Preference {
  BehaviorName better;
  BehaviorName worse;
  bool is_tie = false;  // the two are equally good
  int line = 0;         // where it stands in the file; 0: nowhere yet

  std::string text() const;  // "seed3 over seed1", "seed2 as good as seed7"
};

// In the order of the file; none without it.
std::vector<Preference> ReadPreferences(const std::filesystem::path& folder);

// Appends those that are not there yet, all at once or nothing. Returns how
// many.
size_t AddPreferences(const std::filesystem::path& folder,
                      const std::vector<Preference>& preferences);

}  // namespace runtime
