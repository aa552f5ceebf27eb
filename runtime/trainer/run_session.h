// What `train` and `resume` have in common.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

#include "runtime/module/context.h"
#include "runtime/module/network.h"
#include "runtime/run/progress.h"
#include "runtime/run/run_database.h"

namespace runtime {

// --json and --quiet.
struct OutputOptions {
  bool json = false;
  bool quiet = false;

  void AddTo(CLI::App& command);
  ProgressStyle style() const;
};

// Trains until all episodes are done or the user stops it, from the last checkpoint if there is
// one; returns the exit status. `network` is that of `run`, started.
int RunSession(const std::filesystem::path& folder, Network& network, const RunRecord& run,
               RunDatabase& database, ProgressStyle style);

}  // namespace runtime
