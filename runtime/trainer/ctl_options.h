// What all commands of `trainer ctl` have in common.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>

namespace runtime {

struct CtlOptions {
  std::filesystem::path run;  // empty: the one under runs/ that answers
  bool json = false;

  void AddTo(CLI::App& command);
  // Throws UserError where no run was named and none, or more than one, answers.
  std::filesystem::path FindRun() const;
};

}  // namespace runtime
