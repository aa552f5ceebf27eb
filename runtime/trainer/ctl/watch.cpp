// trainer ctl watch: swaps a task whenever one of its files is saved, for as long as there is a
// trainer.
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <ctime>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "base/text/print.h"
#include "base/watch/file_watch.h"
#include "runtime/base/user_error.h"
#include "runtime/live/client/client.h"
#include "runtime/live/client/task_files.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/ctl/options.h"
#include "runtime/trainer/ctl/trainer_end.h"

namespace runtime {
namespace {

using command_line::CallError;
using Clock = std::chrono::steady_clock;

constexpr const char* kAlready = "already";  // what a swap that changes nothing replies

struct WatchOptions {
  std::filesystem::path file;
  std::string name = "task";
  bool now = false;
  bool forget = false;
};

class TaskWatch {
 public:
  TaskWatch(const CtlOptions& ctl, WatchOptions options)
      : is_for_a_program_(ctl.json),
        run_(ctl.FindRun()),
        options_(std::move(options)),
        trainer_end_(run_) {
    if (!std::filesystem::exists(options_.file)) {
      throw CallError(fmt::format("{}: there is no such file", options_.file.string()));
    }
    options_.file = std::filesystem::absolute(options_.file).lexically_normal();
    WatchFiles();
    const std::vector<std::string> names(files_.begin(), files_.end());
    Print({{"watching", names}}, fmt::format("watching {}\n", fmt::join(names, ", ")));
  }

  // Until Ctrl-C ends the program. Throws UserError once the trainer has ended.
  [[noreturn]] void Run() {
    while (watch_.Wait(trainer_end_.descriptor())) {
      if (!std::filesystem::exists(options_.file)) continue;
      Swap();
      WatchFiles();
    }
    throw UserError(
        fmt::format("{}: the trainer has ended, so nothing is watched any more; `trainer resume "
                    "{}` continues the run",
                    run_.string(), run_.string()));
  }

 private:
  // Those of the last time too: a file may be gone for a moment.
  void WatchFiles() {
    files_.merge(FilesOfTask(options_.file));
    watch_.Watch(files_);
  }

  // A save that changes nothing makes nothing forgotten: that is asked for once the task is
  // another.
  Reply AskForSwap() const {
    const Reply reply = Ask(false);
    const bool changes = reply.ok && reply.value.value("takes_effect", "") != kAlready;
    return changes && options_.forget ? Ask(true) : reply;
  }

  Reply Ask(bool forget) const {
    nlohmann::json arguments = {{"name", options_.name}, {"file", options_.file.string()}};
    if (options_.now) arguments["now"] = true;
    if (forget) arguments["forget"] = true;
    try {
      return runtime::Ask(run_, {"swap", std::move(arguments)});
    } catch (const UserError& error) {
      return {.ok = false, .error = error.what()};
    }
  }

  void Swap() const {
    const auto begin = Clock::now();
    const Reply reply = AskForSwap();
    const auto time = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - begin);
    const std::string name = options_.file.filename().string();
    if (reply.ok) {
      std::string messages = reply.value.value("messages", "");
      if (!messages.empty()) messages += "\n";
      Print({{"ok", true}, {"value", reply.value}, {"milliseconds", time.count()}},
            fmt::format("{} {} ({})\n{}", name, Outcome(reply.value), time, messages));
    } else {
      Print({{"ok", false}, {"error", reply.error}, {"milliseconds", time.count()}},
            fmt::format("{} is not swapped:\n{}\n", name, reply.error));
    }
  }

  // "takes effect: now". Nobody who saves a file knows what others have promoted meanwhile.
  std::string Outcome(const nlohmann::json& reply) const {
    const std::string takes_effect = reply.value("takes_effect", "soon");
    const std::string outcome = takes_effect == kAlready
                                    ? "is there already: nothing to swap"
                                    : fmt::format("takes effect: {}", takes_effect);
    if (reply.value("role", "active") == "active") return outcome;
    return fmt::format("{}, as a shadow: another task pays the learner until `{}` is promoted",
                       outcome, options_.name);
  }

  // At once, for a program or, with the time of day, for a person.
  void Print(const nlohmann::json& object, const std::string& text) const {
    if (is_for_a_program_) {
      text::Print("{}\n", object.dump());
    } else {
      text::Print("{:%H:%M:%S} {}", fmt::localtime(std::time(nullptr)), text);
    }
    std::fflush(stdout);
  }

  const bool is_for_a_program_;
  const std::filesystem::path run_;
  WatchOptions options_;
  std::set<std::filesystem::path> files_;
  watch::FileWatch watch_;
  TrainerEnd trainer_end_;
};

}  // namespace

void AddCtlWatch(command_line::Command& ctl, const std::shared_ptr<CtlOptions>& ctl_options) {
  const auto options = std::make_shared<WatchOptions>();
  command_line::Command& command = ctl.AddCommand(
      "watch", "swaps a task whenever its file, or one that it imports or extends, is saved");
  ctl_options->AddTo(command);
  command.AddOption("FILE", options->file, "a .task file").Required().ValueName("");
  command.AddOption("--name", options->name, "name of the task module").ShowDefault();
  command.AddFlag("--now", options->now,
                  "between two time steps; by default when the next episode starts");
  command.AddFlag("--forget", options->forget, "forget what was learned and start over");
  command.OnRun([ctl_options, options]() -> int { TaskWatch(*ctl_options, *options).Run(); });
}

}  // namespace runtime
