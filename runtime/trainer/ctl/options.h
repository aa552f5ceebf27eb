// What the commands of `trainer ctl` have in common.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

namespace runtime {

struct CtlOptions {
  std::filesystem::path run;  // empty: the one under runs/ that answers
  bool json = false;

  void AddTo(CLI::App& command);
  // Throws UserError where no run was named and none, or more than one, answers.
  std::filesystem::path FindRun() const;
};

// trainer ctl watch
void AddCtlWatch(CLI::App& ctl, const std::shared_ptr<CtlOptions>& options);

}  // namespace runtime
