#include "runtime/trainer/ctl/options.h"

#include "runtime/live/client/find_trainer.h"

namespace runtime {

void CtlOptions::AddTo(command_line::Command& command) {
  command
      .AddOption(kRun, run,
                 "folder of the run; by default the one under runs/ that is being trained")
      .ValueName("RUN");
  command.AddFlag("--json", json, "print JSON, one object per line");
}

std::filesystem::path CtlOptions::FindRun() const {
  return run.empty() ? FindTrainer("runs") : run;
}

}  // namespace runtime
