#include "runtime/trainer/runs/run_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "runtime/analysis/report/report.h"
#include "runtime/base/build_task.h"
#include "runtime/live/server/server.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/runs/many_runs.h"
#include "runtime/trainer/setup/sandbox_rules.h"
#include "runtime/training/run/machine_record.h"
#include "runtime/training/run/record_error.h"
#include "runtime/training/run/run_settings.h"
#include "runtime/training/run/stop_request.h"
#include "runtime/training/run/training.h"

namespace runtime {
namespace {

// Where a change by a client has made the graph fail, the run continues without it;
// otherwise it ends. Nobody's change is to blame for what the disk does.
int Fail(const RunParts& run, LiveRun& live, Progress& progress, const UserError& error) {
  const std::string name = run.folder.string();
  const bool is_of_record = dynamic_cast<const RecordError*>(&error) != nullptr;
  if (!is_of_record && live.BlameLastChange(error.what())) {
    progress.Warn(
        fmt::format("warning: {}; the last change is undone, and the run continues from the "
                    "last checkpoint",
                    error.what()));
    if (IsGuarded()) return StartAgain();
  }
  throw UserError(fmt::format(
      "{}; what was saved is kept, and `trainer resume {}` continues from the last checkpoint",
      error.what(), name));
}

PageMaker PagesOf(const std::filesystem::path& folder) {
  return [folder](Page page, const std::string& nonce, const std::string&) {
    switch (page) {
      case Page::kLive:
        return LivePage(folder, nonce);
      case Page::kReport:
        return ReportPage(folder);
      case Page::kRecord:
        return RecordText(folder);
    }
    return std::string();
  };
}

// Where clients cannot be served, such as on a disk without sockets, the run is worth as much:
// null, unless a server was asked for.
std::unique_ptr<Server> StartServer(const RunParts& run, const SessionOptions& options,
                                    Descriptor loopback, LiveRun& live, Progress& progress) {
  try {
    const ServerOptions server = {.folder = run.folder,
                                  .port = options.port,
                                  .loopback = loopback.Release(),
                                  .language_server = {CompilerProgram().string(), "lsp", "--robots",
                                                      live.robots_folder().string()}};
    return std::make_unique<Server>(server, live, PagesOf(run.folder));
  } catch (const UserError& error) {
    if (options.port != 0 || options.when_done == LiveRun::WhenDone::kWait) throw;
    progress.Warn(fmt::format("warning: {}; the run continues, but `trainer ctl` cannot reach it",
                              error.what()));
    return nullptr;
  }
}

// A run that is continued where other bits are computed is another run from there on.
void NoteMachine(const RunParts& run, int64_t episode, Progress& progress) {
  const MachineFacts here = ThisMachine();
  const std::string why = WhyOtherBits(FactsAt(ReadMachines(run.folder), episode - 1), here);
  if (!why.empty()) {
    progress.Warn(
        fmt::format("warning: {}: this machine computes otherwise than the one before "
                    "({}): the run goes on, but not bit for bit",
                    run.folder.string(), why));
  }
  SetMachine(run.folder, {episode, here});
}

// Where it cannot be now, it may be once another task is there.
void RunSideBySide(Training& training, const RunParts& run, const SessionOptions& options,
                   Progress& progress) {
  const int jobs = EpisodesAtATime(options.jobs);
  if (jobs == 1) return;
  const std::string why_not = training.WhyNotSideBySide();
  if (!why_not.empty() && options.jobs > 1) {
    progress.Note(fmt::format("one episode at a time: {}", why_not));
  }
  training.RunSideBySide(jobs, run.types, run.context);
}

}  // namespace

void OutputOptions::AddTo(command_line::Command& command, const std::string& objects) {
  const command_line::Option json_flag =
      command.AddFlag("--json", json, fmt::format("print {}, and nothing else", objects));
  command.AddFlag("--quiet", quiet, "print only warnings and errors").Excludes(json_flag);
  command.AddFlag("--plain", plain,
                  "on a terminal, too: print lines that stay, rather than keep some up to date");
}

ProgressStyle OutputOptions::style() const {
  if (json) return ProgressStyle::kJson;
  if (quiet) return ProgressStyle::kQuiet;
  return plain ? ProgressStyle::kPlain : ProgressStyle::kText;
}

SessionOptions SessionOptions::At(Pace pace) const {
  SessionOptions options = *this;
  if (pace == Pace::kOneAtATime) options.jobs = 1;
  return options;
}

void SessionOptions::AddTo(command_line::Command& command) {
  output.AddTo(command);
  command
      .AddOption("--port", port,
                 "port on 127.0.0.1 that clients can connect to; by default any free one")
      .Range(1, 65535);
  in_sandbox = true;
  AddSandboxOption(command);
}

int RunSession(const RunParts& run, const SessionOptions& options, Descriptor loopback) {
  const std::string name = run.folder.string();
  TellGuard(run.folder);
  const StopRequest stop;
  Progress progress(options.output.style(), run.record, stdout, stderr);
  LiveRun live(run, progress, options.when_done, stop);
  live.RescoreBy([folder = run.folder](const std::filesystem::path& plugin, int64_t episode) {
    const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
    return std::vector<std::string>{
        program,         "rescore",   folder.string(),         "--task",
        plugin.string(), "--episode", std::to_string(episode), "--json"};
  });
  Training training(run.graph, run.record, run.database, progress, live);
  training.Restore();
  NoteMachine(run, training.episodes_done() + 1, progress);
  RunSideBySide(training, run, options, progress);
  const std::unique_ptr<Server> server =
      StartServer(run, options, std::move(loopback), live, progress);
  live.PublishTo(server.get());
  progress.Note(fmt::format("{}: task {}, {}, seed {}, episodes {} to {}", name,
                            run.record.tasks.front().task, RobotText(run.record), run.record.seed,
                            training.episodes_done() + 1, run.record.episodes_planned));
  if (options.when_done == LiveRun::WhenDone::kWait) {
    progress.Note(fmt::format("{} (`trainer ctl --run {} status`)", server->page_address(), name));
  } else if (server != nullptr && progress.is_live()) {
    progress.Note(server->page_address());
  }
  try {
    const bool is_finished = training.Run(stop);
    progress.Leave();
    if (is_finished && stop.signal() == 0) {
      progress.Note(fmt::format("finished; `trainer report {}` draws the curves", name));
      return kSuccess;
    }
  } catch (const UserError& error) {
    return Fail(run, live, progress, error);
  }
  progress.Note(fmt::format("stopped; `trainer resume {}` continues", name));
  return stop.signal() == 0 ? kSuccess : kStoppedBySignal + stop.signal();
}

}  // namespace runtime
