// What it costs that tasks can be exchanged, compared and talked to while a robot learns.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "plugins/host/task_frame.h"
#include "plugins/robot/robot_description.h"
#include "runtime/base/scratch_folder.h"
#include "runtime/base/user_error.h"
#include "runtime/core/agent/agent.h"
#include "runtime/live/client/client.h"
#include "runtime/live/control/live_graph.h"
#include "runtime/training/run/module_types.h"
#include "runtime/training/simulation/robot_environment.h"

namespace runtime {
namespace {

std::shared_ptr<const Plugin> LoadTask(const std::string& name) {
  return std::make_shared<const Plugin>(std::string(PLUGIN_FOLDER) + "/" + name + ".so");
}

// The humanoid with its default agent, in the first steps of crawling.
class Humanoid {
 public:
  Humanoid() {
    graph_.Start();
    environment().StartEpisode();
    for (int step = 0; step < 20; ++step) environment().RunTimeStep();
  }

  RobotEnvironment& environment() { return graph_.FindOnly<RobotEnvironment>(); }
  UniversalTask& task() { return graph_.FindOnly<UniversalTask>(); }
  LiveGraph& live() { return live_; }
  // Nothing hears what the task pays: only the task itself is measured.
  void Isolate() {
    for (Port* slot : task().reward.Connections()) Port::Disconnect(task().reward, *slot);
  }

 private:
  robot::RobotDescription robot_ = robot::ReadRobot(SOURCE_DIR "/plugins/humanoid/robot.toml");
  const ModuleTypes& types_ = ProgramModuleTypes();
  Context context_{&robot_, LoadTask("crawling"), 1};
  ModuleGraph graph_ =
      BuildGraph(ReadAgent(SOURCE_DIR "/plugins/humanoid/agent.toml", {}), types_, context_);
  LiveGraph live_{graph_, types_, context_};
};

// ---- A time step ----------------------------------------------------------------------------

// The plugin's function with nothing around it.
void EventOfThePlugin(benchmark::State& state) {
  Humanoid humanoid;
  humanoid.Isolate();
  const taskc_plugin& table = humanoid.task().plugin();
  host::TaskFrame task(table);
  for (uint32_t i = 0; i < table.sensor_count; ++i) {
    auto& port = dynamic_cast<SensorOut&>(humanoid.environment().FindPort(table.sensors[i].name));
    task.sensor(i) = port().data;
  }
  task.Initialize();
  const taskc_event_function volatile function = table.events[TASKC_END_OF_TIME_STEP];
  for (auto _ : state) {
    taskc_frame* frame = task.Next(0.005);
    function(frame);
    benchmark::DoNotOptimize(frame->reward);
  }
}
BENCHMARK(EventOfThePlugin);

// Through the instance that can be exchanged, watched by the guard, with its checks.
void EventOfAnInstance(benchmark::State& state) {
  Humanoid humanoid;
  TaskInstance instance(humanoid.task().instance().plugin());
  for (uint32_t i = 0; i < instance.table().sensor_count; ++i) {
    auto& port =
        dynamic_cast<SensorOut&>(humanoid.environment().FindPort(instance.table().sensors[i].name));
    *instance.sensor_data(i) = port().data;
  }
  for (auto _ : state) benchmark::DoNotOptimize(instance.Call(TASKC_END_OF_TIME_STEP, 0.005));
}
BENCHMARK(EventOfAnInstance);

// Through the module, which brings its sensors up to date and emits the reward.
void EventOfAModule(benchmark::State& state) {
  Humanoid humanoid;
  humanoid.Isolate();
  for (auto _ : state) humanoid.task().on_end_of_time_step(0.005);
}
BENCHMARK(EventOfAModule);

// The same event for the active task and as many shadows of another kind.
void EventWithShadows(benchmark::State& state) {
  Humanoid humanoid;
  humanoid.Isolate();
  std::vector<UniversalTask*> tasks = {&humanoid.task()};
  const auto plugin = LoadTask("crawling");
  // A shadow listens like the active task, which pays the learner: give it one.
  auto& learner = humanoid.live().graph().FindPort("learner.reward");
  Port::Connect(humanoid.task().reward, learner);
  for (int64_t i = 0; i < state.range(0); ++i) {
    tasks.push_back(
        &humanoid.live().Load(fmt::format("shadow{}", i), std::make_unique<TaskInstance>(plugin)));
    tasks.back()->SetRole(UniversalTask::Role::kShadowEndsWithAction);
    tasks.back()->on_start_of_episode();
  }
  Port::Disconnect(humanoid.task().reward, learner);
  Slot<double>* active = &humanoid.task().on_end_of_time_step;
  Signal<double> signal(&humanoid.environment(), "bench");
  signal.Connect(*active);
  for (size_t i = 1; i < tasks.size(); ++i) signal.Connect(tasks[i]->on_end_of_time_step);
  for (auto _ : state) signal(0.005);
}
BENCHMARK(EventWithShadows)->Arg(0)->Arg(1)->Arg(2)->Arg(4);

// ---- Swaps ----------------------------------------------------------------------------------

// From a plugin's file to the first event, and the old plugin unloaded.
void Swap(benchmark::State& state) {
  Humanoid humanoid;
  const char* names[] = {"turning", "crawling"};
  size_t next = 0;
  for (auto _ : state) {
    humanoid.live().Swap("task", std::make_unique<TaskInstance>(LoadTask(names[next++ % 2])));
  }
}
BENCHMARK(Swap)->Unit(benchmark::kMicrosecond);

// ---- A trainer and a client that does not leave it alone ------------------------------------

pid_t StartTrainer(const std::filesystem::path& run) {
  std::vector<std::string> words = {
      TRAINER,     "train",   SOURCE_DIR "/tasks/forward_rolling.task",
      "--profile", "fast",    "--episodes",
      "10",        "--quiet", "--out",
      run.string()};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t process = 0;
  if (posix_spawn(&process, TRAINER, nullptr, nullptr, arguments.data(), environ) != 0) return 0;
  return process;
}

// Reads the events and asks ten times a second.
class Client {
 public:
  explicit Client(const std::filesystem::path& run)
      : listener_([=] { WhenThere(run, [&] { FollowEvents(run, [](const auto&) {}); }); }),
        asker_([=, this] {
          while (!is_over_) {
            WhenThere(run, [&] { Ask(run, {"list", nlohmann::json::object()}); });
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
          }
        }) {}
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;
  ~Client() {
    is_over_ = true;
    listener_.join();
    asker_.join();
  }

 private:
  template <class Action>
  static void WhenThere(const std::filesystem::path& run, Action action) {
    for (int tries = 0; tries < 100 && !std::filesystem::exists(run / "control.json"); ++tries) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    try {
      action();
    } catch (const UserError&) {  // it has ended
    }
  }

  std::atomic<bool> is_over_ = false;
  std::thread listener_;
  std::thread asker_;
};

// A whole short run; the argument says whether a client is attached.
void Training(benchmark::State& state) {
  for (auto _ : state) {
    const ScratchFolder folder;
    const std::filesystem::path run = folder.path() / "run";
    const pid_t trainer = StartTrainer(run);
    std::unique_ptr<Client> client;
    if (state.range(0) != 0) client = std::make_unique<Client>(run);
    int status = 0;
    waitpid(trainer, &status, 0);
    if (status != 0) state.SkipWithError("the trainer failed");
    state.PauseTiming();
    client.reset();
    state.ResumeTiming();
  }
}
BENCHMARK(Training)->ArgName("client")->Arg(0)->Arg(1)->UseRealTime()->Unit(benchmark::kSecond);

}  // namespace
}  // namespace runtime

BENCHMARK_MAIN();
