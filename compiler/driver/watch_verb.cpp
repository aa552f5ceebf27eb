// taskc watch FILE.task...
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <ctime>
#include <memory>
#include <set>
#include <system_error>

#include "base/text/print.h"
#include "base/watch/file_watch.h"
#include "compiler/driver/verb.h"
#include "compiler/emit/emit.h"
#include "compiler/toolchain/build_plugin.h"
#include "compiler/toolchain/plugin_cache.h"

namespace compiler {
namespace {

struct WatchOptions {
  std::vector<std::string> tasks;
  std::filesystem::path cache;  // empty: the default
};

// Ctrl-C makes the first of these readable.
std::array<int, 2> stop_pipe = {-1, -1};

void OnInterrupt(int) { [[maybe_unused]] const ssize_t ignored = write(stop_pipe[1], "", 1); }

void CatchInterrupts() {
  if (pipe(stop_pipe.data()) != 0) throw CallError("cannot create a pipe");
  struct sigaction action {};
  action.sa_handler = OnInterrupt;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

// The files of a task; those of the last time too, while it cannot be read to its end.
using Files = std::set<std::filesystem::path>;

// One task, built once. Says how it went in a line of its own.
void BuildOne(const std::string& task, const WatchOptions& options, Session& session,
              Files& files) {
  files.insert(task);
  const Analysis analysis = session.Analyze(task);
  for (const SourceFile& file : analysis.sources.files()) files.insert(file.path());
  if (analysis.robot) files.insert(analysis.robot->file);
  if (!analysis.task) return;
  const auto cache = options.cache.empty() ? DefaultCacheFolder() : options.cache;
  const BuildResult built =
      BuildPlugin(analysis.task->name, Emit(*analysis.task, analysis.sources), cache);
  text::Print("{}\n", built.plugin.string());
}

// All tasks: a block with the time of day, what is wrong, and where the plugins are.
void BuildAll(const WatchOptions& options, const Session& settings, Files& files) {
  text::Print("-- {:%H:%M:%S}\n", fmt::localtime(std::time(nullptr)));
  std::fflush(stdout);
  Session session = settings;
  for (const std::string& task : options.tasks) {
    try {
      BuildOne(task, options, session, files);
    } catch (const CallError& error) {
      session.Fail(error.what());
    } catch (const robot::DescriptionError& error) {
      session.Fail(error.what());
    }
  }
  session.Finish(ExitStatus::kOk);
  std::fflush(stdout);
}

ExitStatus Watch(const WatchOptions& options, const Session& session) try {
  CatchInterrupts();
  watch::FileWatch watch;
  Files files(options.tasks.begin(), options.tasks.end());
  watch.Watch(files);
  do {
    BuildAll(options, session, files);
    watch.Watch(files);
  } while (watch.Wait(stop_pipe[0]));
  return ExitStatus::kOk;
} catch (const std::system_error& error) {
  throw CallError(error.what());
}

}  // namespace

Action DeclareWatch(Command& command, Session& session) {
  auto options = std::make_shared<WatchOptions>();
  AddTasks(command, options->tasks);
  command.AddOption("--cache", options->cache, "folder for built plugins").ValueName("DIR");
  AddRobots(command, session);
  return [options](Session& call) { return Watch(*options, call); };
}

}  // namespace compiler
