#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "base/text/print.h"
#include "runtime/base/file_remover.h"
#include "runtime/base/local_socket.h"
#include "runtime/core/task/universal_task.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/environment/environment_session.h"
#include "runtime/trainer/setup/sandbox_rules.h"
#include "runtime/trainer/setup/start_check.h"
#include "runtime/trainer/setup/task_setup.h"
#include "runtime/training/run/stop_request.h"
#include "runtime/training/run/task_record.h"

namespace runtime {
namespace {

constexpr std::chrono::milliseconds kBetweenLooks{100};  // for a signal

struct EnvironmentOptions {
  TaskOptions task;
  std::filesystem::path socket;
  uint64_t seed = 0;
  double discount = 0.99;
};

// A client in a thread of its own.
class ServedClient {
 public:
  ServedClient(const SharedEnvironment& shared, LocalSocket socket)
      : session_(shared, std::move(socket)), thread_([this] { Serve(); }) {}
  ~ServedClient() { session_.Interrupt(); }

  bool is_gone() const { return is_gone_; }

 private:
  void Serve() {
    try {
      session_.Run();
    } catch (const UserError& error) {
      text::Print(stderr, "trainer: error: {}\n", error.what());
    }
    is_gone_ = true;
    session_.Interrupt();  // so that the client hears of it
  }

  EnvironmentSession session_;
  std::atomic<bool> is_gone_ = false;
  std::jthread thread_;
};

int Serve(const EnvironmentOptions& options) {
  const BuiltTask task(options.task);
  if (!task.plugin()) return kFailed;
  // Before it is in the sandbox, which lets it neither listen at this place nor tidy it up.
  const LocalListener listener(options.socket);
  const FileRemover remover(options.socket);
  std::optional<CommandSandbox> sandbox;
  TaskSetup setup(options.task, *task.plugin(), options.seed, ProgramModuleTypes(),
                  [&](const TaskSetup& known) {
                    SandboxRules rules = RulesOf(known);
                    task.AddTo(rules.files);
                    sandbox.emplace(std::move(rules));
                  });
  CheckCanBeOutside(setup);
  const std::string& module = setup.graph.FindOnly<UniversalTask>().name();
  const SharedEnvironment shared{setup, DescribeTask(setup.plugin->table(), module),
                                 options.discount};
  setup.graph.Start();  // what is wrong is said before anybody connects
  WarnOfStart(setup);
  const StopRequest stop;
  text::Print("{}: task {} listens ... Ctrl-C to stop\n", options.socket.string(),
              shared.task.task);
  std::fflush(stdout);
  std::list<ServedClient> clients;
  while (stop.signal() == 0) {
    std::optional<LocalSocket> socket = listener.Accept(kBetweenLooks);
    std::erase_if(clients, [](const ServedClient& client) { return client.is_gone(); });
    if (socket) clients.emplace_back(shared, std::move(*socket));
  }
  return kSuccess;
}

}  // namespace

void AddEnvironmentCommand(command_line::Command& program) {
  const auto options = std::make_shared<EnvironmentOptions>();
  options->task.agent = "ppo";
  command_line::Command& command = program.AddCommand(
      "environment",
      "Offers a robot and its task to programs in any language, which reset it, decide and are "
      "rewarded, over a socket (docs/environments.md).");
  options->task.AddTo(command);
  command
      .AddOption("--socket", options->socket,
                 "where to listen; each program that connects has an environment of its own")
      .ValueName("PATH")
      .Required();
  command.AddOption("--seed", options->seed, "random seed of what the task draws")
      .NonNegative()
      .ShowDefault();
  command
      .AddOption("--discount", options->discount,
                 "of the learner outside, for a task that pays a potential")
      .Range(0, 1)
      .ShowDefault();
  AddSandboxOption(command);
  command.OnRun([options] { return Serve(*options); });
}

}  // namespace runtime
