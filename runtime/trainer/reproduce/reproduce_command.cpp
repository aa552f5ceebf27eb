#include <memory>
#include <nlohmann/json.hpp>

#include "base/text/print.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/reproduce/reproduce_run.h"
#include "runtime/trainer/reproduce/reproduction_text.h"
#include "runtime/trainer/runs/many_runs.h"
#include "runtime/trainer/runs/run_session.h"
#include "runtime/trainer/setup/sandbox_rules.h"

namespace runtime {
namespace {

struct CommandOptions {
  ReproduceOptions reproduce;
  bool kept_plugins = false;
  OutputOptions output;
};

int Reproduce(CommandOptions& options) {
  ReproduceOptions& reproduce = options.reproduce;
  reproduce.plugins = options.kept_plugins ? Plugins::kKept : Plugins::kRebuilt;
  reproduce.style = options.output.json ? ProgressStyle::kQuiet : options.output.style();
  const Reproduction found = ReproduceRun(reproduce);
  if (options.output.json) {
    text::Print("{}\n", ReproductionJson(found).dump(-1, ' ', false,
                                                     nlohmann::json::error_handler_t::replace));
  } else if (!options.output.quiet || !found.is_equal()) {
    text::Print("{}", ReproductionText(found));
  }
  if (found.stop_signal != 0) return kStoppedBySignal + found.stop_signal;
  return found.is_equal() ? kSuccess : kFailed;
}

}  // namespace

void AddReproduceCommand(command_line::Command& program) {
  const auto options = std::make_shared<CommandOptions>();
  command_line::Command& command = program.AddCommand(
      "reproduce",
      "Trains a run again from its record alone, and compares it, episode by episode.");
  command.AddOption("RUN", options->reproduce.folder, "folder of the run").Required();
  command
      .AddOption("--episodes", options->reproduce.episodes,
                 "how many, from the first on; by default all that are recorded")
      .Range(1, 1'000'000'000);
  command.AddFlag("--kept-plugins", options->kept_plugins,
                  "run the plugins in the run's folder instead of building its tasks again");
  AddJobsOption(command, options->reproduce.jobs, "how many episodes to run at a time");
  options->output.AddTo(command, "one JSON object at the end");
  command.Notes(
      "The first episode that differs is shown, and what differs of all that computes. The run "
      "itself is only read.");
  command.ExitStatus(
      "0 no episode differs, 1 one does, or the run failed, 2 the command line is wrong, 128 + n "
      "stopped by signal n.");
  AddSandboxOption(command);
  command.OnRun([options] { return Reproduce(*options); });
}

}  // namespace runtime
