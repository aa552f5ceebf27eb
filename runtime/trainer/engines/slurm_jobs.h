// Which task of which job array trains which run: kept in the study's folder, so that a later call
// knows it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace runtime {

struct SlurmArray {
  int64_t job = 0;                // id of the array
  std::vector<std::string> runs;  // by the task's number: folders, relative to the study's
};

// What the engine keeps of the study in `folder`: FOLDER/slurm, with a job's script, its list of
// runs, and what the tasks print.
std::filesystem::path SlurmFolder(const std::filesystem::path& folder);

// Oldest first; none where nothing was submitted. Throws UserError where the file is damaged.
std::vector<SlurmArray> ReadSlurmArrays(const std::filesystem::path& folder);
// Throws UserError.
void AddSlurmArray(const std::filesystem::path& folder, const SlurmArray& array);

}  // namespace runtime
