// What people wrote about the behaviors that they have watched: groups.toml in the study's folder,
//
//   "forward_rolling-fast/seed3" = "Two rolls, then it lies on its back."
//
// A sentence is about a run, and so about the group in which the run is, however the groups change.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace runtime {

inline constexpr const char* kGroupNotesFile = "groups.toml";

// By the names of runs; empty without the file. Throws UserError with the place of a mistake in it.
std::map<std::string, std::string> ReadGroupNotes(const std::filesystem::path& study);

}  // namespace runtime
