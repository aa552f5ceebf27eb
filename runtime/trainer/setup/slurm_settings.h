// What a study says of the cluster that trains its runs: the table [slurm] of its file, and what
// the command line says instead.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/command_line/command.h"

namespace runtime {

struct SlurmSettings {
  std::string partition{};  // "" for the cluster's own choice, as everywhere
  std::string account{};
  std::string time{};    // of one run, as sbatch takes it: "12:00:00"
  std::string memory{};  // of one run: "2G"
  int64_t cpus = 1;      // of one run
  int64_t at_once = 0;   // how many runs at a time, of all in one array; 0: as many as fit
  std::vector<std::string> modules{};  // to load before the trainer starts
  std::vector<std::string> options{};  // of sbatch, as they are: "--exclude=node7"

  void AddTo(command_line::Command& command);
  // What `stronger` says, and where it says nothing this.
  SlurmSettings OverriddenBy(const SlurmSettings& stronger) const;
};

}  // namespace runtime
