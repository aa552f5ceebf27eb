// What the commands of `trainer ctl` have in common.
#pragma once

#include <filesystem>
#include <memory>

#include "base/command_line/command.h"

namespace runtime {

struct CtlOptions {
  static constexpr const char* kRun = "--run";

  std::filesystem::path run;  // empty: the one under runs/ that answers
  bool json = false;

  void AddTo(command_line::Command& command);
  // Throws UserError where no run was named and none, or more than one, answers.
  std::filesystem::path FindRun() const;
};

// trainer ctl watch
void AddCtlWatch(command_line::Command& ctl, const std::shared_ptr<CtlOptions>& options);

}  // namespace runtime
