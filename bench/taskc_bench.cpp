// The compiler's phases, `taskc` as a whole, and a compiled callback beside the same one by hand.
//
// Whole programs are measured by the processor time of the child and of all its own children (g++,
// as, ld), which hardly depends on what else the machine does.
#include <benchmark/benchmark.h>
#include <dlfcn.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <taskc/plugin.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "compiler/check/check.h"
#include "compiler/emit/emit.h"
#include "compiler/source/file_reader.h"
#include "compiler/syntax/parse.h"
#include "compiler/toolchain/build_plugin.h"
#include "compiler/toolchain/file_io.h"
#include "compiler/toolchain/plugin_cache.h"
#include "plugins/host/task_frame.h"

namespace emitted {
#include "crawling_callback.inc"
}

namespace compiler {
namespace {

constexpr const char* kTask = SOURCE_DIR "/tasks/crawling.task";
constexpr const char* kRobot = SOURCE_DIR "/plugins/humanoid/robot.toml";

// ---- Phases ---------------------------------------------------------------------------------

void Parse(benchmark::State& state) {
  Sources sources(kTask, MustReadFromDisk(kTask));
  for (auto _ : state) {
    Diagnostics diagnostics;
    benchmark::DoNotOptimize(Parse(sources.main(), diagnostics));
  }
}
BENCHMARK(Parse)->Unit(benchmark::kMicrosecond);

void ReadRobot(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(robot::ReadRobot(kRobot));
}
BENCHMARK(ReadRobot)->Unit(benchmark::kMicrosecond);

void Check(benchmark::State& state) {
  Sources sources(kTask, MustReadFromDisk(kTask));
  robot::RobotDescription robot = robot::ReadRobot(kRobot);
  Diagnostics diagnostics;
  SyntaxTree tree = Parse(sources.main(), diagnostics).value();
  for (auto _ : state) benchmark::DoNotOptimize(Check(tree, &robot, diagnostics));
}
BENCHMARK(Check)->Unit(benchmark::kMicrosecond);

std::string EmitTask() {
  Sources sources(kTask, MustReadFromDisk(kTask));
  robot::RobotDescription robot = robot::ReadRobot(kRobot);
  Diagnostics diagnostics;
  SyntaxTree tree = Parse(sources.main(), diagnostics).value();
  return Emit(Check(tree, &robot, diagnostics).value(), sources);
}

void Emit(benchmark::State& state) {
  Sources sources(kTask, MustReadFromDisk(kTask));
  robot::RobotDescription robot = robot::ReadRobot(kRobot);
  Diagnostics diagnostics;
  SyntaxTree tree = Parse(sources.main(), diagnostics).value();
  CheckedTask task = Check(tree, &robot, diagnostics).value();
  for (auto _ : state) benchmark::DoNotOptimize(Emit(task, sources));
}
BENCHMARK(Emit)->Unit(benchmark::kMicrosecond);

// ---- The whole program ----------------------------------------------------------------------

double ChildrenSeconds() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// The reported time is processor time.
void RunTaskc(benchmark::State& state, const std::string& arguments,
              const std::filesystem::path& emptied = {}) {
  std::string command = fmt::format("exec '{}' {} >/dev/null", TASKC, arguments);
  for (auto _ : state) {
    if (!emptied.empty()) std::filesystem::remove_all(emptied);
    double before = ChildrenSeconds();
    if (std::system(command.c_str()) != 0) state.SkipWithError("taskc failed");
    state.SetIterationTime(ChildrenSeconds() - before);
  }
}

// A cache of our own, below the folder for temporary files.
std::filesystem::path BenchCache() {
  return std::filesystem::temp_directory_path() / "taskc-bench-cache";
}

// Of those that come with taskc.
std::filesystem::path LargestTask() {
  std::filesystem::path largest = kTask;
  for (const auto& entry : std::filesystem::directory_iterator(SOURCE_DIR "/tasks")) {
    if (entry.path().extension() != ".task") continue;
    if (entry.file_size() > file_size(largest)) largest = entry.path();
  }
  return largest;
}

// Far larger than anyone writes one.
std::filesystem::path TaskOfThousandLines() {
  std::string text = "task long for humanoid\n\nstart standing\n\non end_of_time_step {\n";
  for (int i = 1; i <= 248; ++i) {
    text += fmt::format(
        "  let speed_{0} = norm(base.velocity.xy) * {0}\n"
        "  if any(contact[feet]) and speed_{0} > 0.1 m/s {{\n"
        "    reward rate forward_{0} = dot(base.velocity.xy, base.up.xy) * 0.{0}\n"
        "  }}\n",
        i);
  }
  text += "  if time > 20 s { truncate_episode \"time is up\" }\n  // the 1000 lines are full\n}\n";
  std::filesystem::path file = std::filesystem::temp_directory_path() / "taskc-bench-long.task";
  WriteWholeFile(file, text);
  return file;
}

void CheckProgram(benchmark::State& state) {
  RunTaskc(state, fmt::format("check '{}'", LargestTask().string()));
}
BENCHMARK(CheckProgram)->UseManualTime()->Unit(benchmark::kMillisecond);

void CheckThousandLines(benchmark::State& state) {
  RunTaskc(state, fmt::format("check '{}'", TaskOfThousandLines().string()));
}
BENCHMARK(CheckThousandLines)->UseManualTime()->Unit(benchmark::kMillisecond);

void BuildUncached(benchmark::State& state) {
  RunTaskc(state, fmt::format("build '{}' --cache '{}'", kTask, BenchCache().string()),
           BenchCache());
}
BENCHMARK(BuildUncached)->UseManualTime()->Unit(benchmark::kMillisecond);

void BuildThousandLines(benchmark::State& state) {
  RunTaskc(
      state,
      fmt::format("build '{}' --cache '{}'", TaskOfThousandLines().string(), BenchCache().string()),
      BenchCache());
}
BENCHMARK(BuildThousandLines)->UseManualTime()->Unit(benchmark::kMillisecond);

void BuildCached(benchmark::State& state) {
  RunTaskc(state, fmt::format("build '{}' --cache '{}'", kTask, BenchCache().string()));
}
BENCHMARK(BuildCached)->UseManualTime()->Unit(benchmark::kMillisecond);

// ---- A callback -----------------------------------------------------------------------------

constexpr double kTimeStep = 0.005;

// What the crawling task reads.
struct Sensors {
  double time = 1;
  double base_position[3] = {};
  double base_up[3] = {0.6, 0.1, 0.79};
  double base_velocity[3] = {0.1, 0.02, 0};
  double base_angular_velocity[3] = {0.1, 0.2, 0.3};
  double joint_torque[17] = {0.5, -0.25, 1, 0.125, 0.75};
  bool contact[18] = {};

  // Another step, so that nothing can be computed once for all.
  void Advance() { base_velocity[0] = 0.3 - base_velocity[0]; }
};

// The same task as a person writes it into the trainer: with the same sums and checks, but with the
// sensors and all else at places that the compiler knows.
class HandWritten {
 public:
  explicit HandWritten(const Sensors& sensors) : sensors_(sensors) {}

  double EndOfTimeStep(double time_step) {
    const Sensors& s = sensors_;
    double squares = 0;
    for (double torque : s.joint_torque) squares += torque * torque;
    double reward = 0;
    Pay(reward, kForward,
        0.25 / 0.005 * (s.base_velocity[0] * s.base_up[0] + s.base_velocity[1] * s.base_up[1]) *
            time_step);
    Pay(reward, kTurning,
        -turning_cost_ / 0.005 * std::fabs(s.base_angular_velocity[2]) * time_step);
    Pay(reward, kEffort, -4e-9 / 0.0002 * __builtin_sqrt(squares) * time_step);
    if (!fallen_ && (s.contact[0] || s.contact[1])) {
      fallen_ = true;
      Pay(reward, kFall, -fall_penalty_);
    }
    sum_of_reward_ += reward;
    has_ended_ = sum_of_reward_ < -40 || s.time > 20;
    return reward;
  }
  bool has_ended() const { return has_ended_; }
  int fault() const { return fault_; }

 private:
  enum Term { kForward, kTurning, kEffort, kFall, kTermCount };

  void Pay(double& reward, Term term, double value) {
    if (std::isfinite(reward + value)) {
      reward += value;
      terms_[term] += value;
    } else if (fault_ < 0) {
      fault_ = term;
    }
  }

  const Sensors& sensors_;
  double fall_penalty_ = 4;
  double turning_cost_ = 0.025;
  double sum_of_reward_ = 0;
  double terms_[kTermCount] = {};
  int fault_ = -1;
  bool fallen_ = false;
  bool has_ended_ = false;
};

// Hides from the compiler what an object holds, so that it cannot compute anything ahead.
template <class T>
T& Opaque(T& object) {
  T* place = &object;
  benchmark::DoNotOptimize(place);
  return *place;
}

void CallbackByHand(benchmark::State& state) {
  Sensors own_sensors;
  Sensors& sensors = Opaque(own_sensors);
  HandWritten own_task(sensors);
  HandWritten& task = Opaque(own_task);
  for (auto _ : state) {
    sensors.Advance();
    benchmark::ClobberMemory();
    benchmark::DoNotOptimize(task.EndOfTimeStep(kTimeStep));
    benchmark::DoNotOptimize(task.has_ended());
    benchmark::DoNotOptimize(task.fault());
  }
}
BENCHMARK(CallbackByHand)->Repetitions(5)->ReportAggregatesOnly(true);

const taskc_plugin& LoadTask() {
  static const taskc_plugin* plugin = [] {
    std::filesystem::path file = BuildPlugin("crawling", EmitTask(), BenchCache()).plugin;
    void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) throw std::runtime_error(dlerror());
    return reinterpret_cast<taskc_plugin_entry>(dlsym(library, TASKC_PLUGIN_ENTRY))();
  }();
  return *plugin;
}

const void* FindSensor(const Sensors& sensors, std::string_view name) {
  const std::pair<std::string_view, const void*> places[] = {
      {"time", &sensors.time},
      {"base.position", sensors.base_position},
      {"base.up", sensors.base_up},
      {"base.velocity", sensors.base_velocity},
      {"base.angular_velocity", sensors.base_angular_velocity},
      {"joint.torque", sensors.joint_torque},
      {"contact", sensors.contact}};
  for (const auto& [known, place] : places) {
    if (known == name) return place;
  }
  throw std::runtime_error(fmt::format("the task reads {}, which is not measured here", name));
}

void Bind(const Sensors& sensors, host::TaskFrame& task) {
  for (uint32_t i = 0; i < task.plugin().sensor_count; ++i) {
    task.sensor(i) = FindSensor(sensors, task.plugin().sensors[i].name);
  }
}

template <class Callback>
void CallWithPlugin(benchmark::State& state, const Callback& callback) {
  Sensors own_sensors;
  Sensors& sensors = Opaque(own_sensors);
  host::TaskFrame task(LoadTask());
  Bind(sensors, task);
  task.Initialize();
  for (auto _ : state) {
    sensors.Advance();
    benchmark::ClobberMemory();
    taskc_frame* frame = task.Next(kTimeStep);
    callback(frame);
    benchmark::DoNotOptimize(frame->reward);
    benchmark::DoNotOptimize(frame->end);
  }
}

// What taskc emits, compiled into this program and inlined: the plugin without the way to it.
void CallbackInlined(benchmark::State& state) {
  CallWithPlugin(state, [](taskc_frame* frame) { emitted::end_of_time_step(frame); });
}
BENCHMARK(CallbackInlined)->Repetitions(5)->ReportAggregatesOnly(true);

void CallbackOfPlugin(benchmark::State& state) {
  CallWithPlugin(state, LoadTask().events[TASKC_END_OF_TIME_STEP]);
}
BENCHMARK(CallbackOfPlugin)->Repetitions(5)->ReportAggregatesOnly(true);

}  // namespace
}  // namespace compiler

BENCHMARK_MAIN();
