#include "runtime/trainer/ctl/options.h"

#include "runtime/live/client/find_trainer.h"

namespace runtime {

void CtlOptions::AddTo(CLI::App& command) {
  command.add_option("--run", run, "folder of the run; otherwise the one under runs/ that answers")
      ->type_name("DIR");
  command.add_flag("--json", json, "print JSON, one object in a line");
}

std::filesystem::path CtlOptions::FindRun() const {
  return run.empty() ? FindTrainer("runs") : run;
}

}  // namespace runtime
