// What a time step costs with each of the six tasks, besides physics and learning:
//   Sensing    the sensors that the task reads at the end of every time step, out of the simulation
//   Callback   the task's end_of_time_step on them
// and what functions of the past, a goal, phases and potentials cost, beside the same written out
// with memory, and what tables, observations and starts cost, beside the same in C++.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/by_hand.h"
#include "bench/motion_by_hand.h"
#include "bench/random_motion.h"
#include "plugins/host/task_frame.h"
#include "runtime/core/task/plugin.h"
#include "runtime/training/simulation/robot_sensors.h"

namespace runtime {
namespace {

// `name`: a path in the source tree, without its extension.
const Plugin& LoadTask(const std::string& name) {
  static std::map<std::string, std::unique_ptr<Plugin>> plugins;
  std::unique_ptr<Plugin>& plugin = plugins[name];
  if (plugin != nullptr) return *plugin;
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() /
      fmt::format("task-bench-{}.so", std::filesystem::path(name).filename().string());
  const std::string command = fmt::format("'{}' build '{}/{}.task' -o '{}' >/dev/null 2>&1", TASKC,
                                          SOURCE_DIR, name, file.string());
  if (std::system(command.c_str()) != 0) throw std::runtime_error("taskc failed");
  plugin = std::make_unique<Plugin>(file);
  std::filesystem::remove(file);
  return *plugin;
}

// The robot in the middle of a random motion, and the sensors of a task there.
class Scene {
 public:
  explicit Scene(const taskc_plugin& plugin)
      : world_(Humanoid(), FindProfile("fast-tree"), Humanoid().poses[0]),
        sensors_(Humanoid(), nullptr) {
    std::vector<double> targets(Humanoid().joints.size());
    RandomMotion motion(1);
    for (int step = 0; step < 200; ++step) {
      motion.Next(targets);
      for (int i = 0; i < world_.physics_steps_per_time_step(); ++i) world_.Step(targets);
    }
    for (const taskc_sensor& sensor : std::span(plugin.sensors, plugin.sensor_count)) {
      RobotSensor& found = Find(sensor.name);
      found_.push_back(&found);
      if ((sensor.read_by & 1u << TASKC_END_OF_TIME_STEP) != 0) read_.push_back(&found);
    }
    Sense();
  }

  // As in every time step.
  void Sense() {
    sensors_.Refresh(world_, 1);
    for (RobotSensor* sensor : read_) benchmark::DoNotOptimize(sensor->Read().data);
  }

  void Bind(host::TaskFrame& frame) {
    for (size_t i = 0; i < found_.size(); ++i) frame.sensor(i) = found_[i]->Read().data;
  }

 private:
  RobotSensor& Find(std::string_view name) {
    for (RobotSensor& sensor : sensors_.sensors()) {
      if (sensor.description().name == name) return sensor;
    }
    throw std::runtime_error("the robot lacks a sensor");
  }

  World world_;
  RobotSensors sensors_;
  std::vector<RobotSensor*> found_;  // in the plugin's order
  std::vector<RobotSensor*> read_;   // at the end of a time step
};

void Sensing(benchmark::State& state, const char* task) {
  Scene scene(LoadTask(task).table());
  for (auto _ : state) scene.Sense();
}

void Call(benchmark::State& state, const char* task, int event, double time_step) {
  const taskc_plugin& plugin = LoadTask(task).table();
  Scene scene(plugin);
  host::TaskFrame frame(plugin);
  scene.Bind(frame);
  frame.Initialize();
  frame.Call(TASKC_START_OF_EPISODE, 0);
  const taskc_event_function callback = plugin.events[event];
  for (auto _ : state) {
    benchmark::ClobberMemory();
    callback(frame.Next(time_step));
    benchmark::DoNotOptimize(frame.frame().reward);
  }
}

void Callback(benchmark::State& state, const char* task) {
  Call(state, task, TASKC_END_OF_TIME_STEP, 0.005);
}

void EndOfAction(benchmark::State& state, const char* task) {
  Call(state, task, TASKC_END_OF_ACTION, 0);
}

const void* DataOf(const host::TaskFrame& frame, std::string_view name) {
  const taskc_plugin& plugin = frame.plugin();
  for (taskc_uint32 i = 0; i < plugin.sensor_count; ++i)
    if (plugin.sensors[i].name == name) return frame.frame().sensors[i];
  throw std::runtime_error("the task lacks a sensor");
}

const double* RealsOf(const host::TaskFrame& frame, std::string_view name) {
  return static_cast<const double*>(DataOf(frame, name));
}

void Observe(benchmark::State& state) {
  const taskc_plugin& plugin = LoadTask("bench/tasks/observe").table();
  Scene scene(plugin);
  host::TaskFrame frame(plugin);
  scene.Bind(frame);
  frame.Initialize();
  for (auto _ : state) {
    benchmark::ClobberMemory();
    frame.Observe();
    benchmark::DoNotOptimize(frame.observations().data());
  }
}

void ObserveByHand(benchmark::State& state) {
  const taskc_plugin& plugin = LoadTask("bench/tasks/observe").table();
  Scene scene(plugin);
  host::TaskFrame frame(plugin);
  scene.Bind(frame);
  const std::vector<double>& rest = Humanoid().poses[0].joint_angles;
  const double command[] = {0.3, 0.1};
  const ObservationByHand by_hand{
      .orientation = RealsOf(frame, "base.orientation"),
      .velocity = RealsOf(frame, "base.velocity"),
      .angular_velocity = RealsOf(frame, "base.angular_velocity"),
      .up = RealsOf(frame, "base.up"),
      .angles = RealsOf(frame, "joint.angle"),
      .joint_velocities = RealsOf(frame, "joint.velocity"),
      .contacts = static_cast<const unsigned char*>(DataOf(frame, "contact")),
      .command = command,
      .rest = rest.data()};
  std::vector<double> observed(plugin.observation_size);
  for (auto _ : state) {
    benchmark::ClobberMemory();
    by_hand.Observe(observed.data());
    benchmark::DoNotOptimize(observed.data());
  }
}

// What a task draws; without what the trainer makes of it.
void DrawStart(benchmark::State& state) {
  host::TaskFrame frame(LoadTask("bench/tasks/drawn").table());
  frame.Initialize();
  taskc_uint64 seed = 0;
  for (auto _ : state) {
    frame.SetSeed(++seed);
    benchmark::DoNotOptimize(frame.DrawPose());
    frame.DrawStart();
    benchmark::ClobberMemory();
  }
}

void DrawStartByHand(benchmark::State& state) {
  std::vector<double> low;
  std::vector<double> high;
  for (const robot::Joint& joint : Humanoid().joints) {
    low.push_back(joint.low);
    high.push_back(joint.high);
  }
  StartByHand start(1);
  for (auto _ : state) {
    std::vector<double> angles = Humanoid().poses[0].joint_angles;
    double position[3] = {};
    double velocity[3] = {};
    double yaw = 0;
    start.Draw(low, high, angles, position, &yaw, velocity);
    benchmark::DoNotOptimize(angles.data());
    benchmark::DoNotOptimize(start.pose());
  }
}

// On the same sensors; without what a callback does for every task.
void TableByHand(benchmark::State& state) {
  const taskc_plugin& plugin = LoadTask("bench/tasks/table").table();
  Scene scene(plugin);
  host::TaskFrame frame(plugin);
  scene.Bind(frame);
  static const MotionByHand motion(SOURCE_DIR "/examples/tasks/track.csv");
  const double* time = RealsOf(frame, "time");
  const double* angles = RealsOf(frame, "joint.angle");
  const double* positions = RealsOf(frame, "link.position");
  for (auto _ : state) {
    benchmark::ClobberMemory();
    benchmark::DoNotOptimize(0.005 * motion.Reward(*time, angles, positions));
  }
}

#define TASK(name)                                  \
  BENCHMARK_CAPTURE(Sensing, name, "tasks/" #name); \
  BENCHMARK_CAPTURE(Callback, name, "tasks/" #name)
TASK(crawling);
TASK(handstanding);
TASK(jumping);
TASK(forward_rolling);
TASK(backward_rolling);
TASK(turning);
#undef TASK
BENCHMARK_CAPTURE(Callback, past, "bench/tasks/past");
BENCHMARK_CAPTURE(Callback, past_by_hand, "bench/tasks/past_by_hand");
BENCHMARK_CAPTURE(Callback, table, "bench/tasks/table");
BENCHMARK(TableByHand);
BENCHMARK_CAPTURE(Callback, phases, "bench/tasks/phases");
BENCHMARK_CAPTURE(Callback, phases_by_hand, "bench/tasks/phases_by_hand");
BENCHMARK_CAPTURE(EndOfAction, potential, "bench/tasks/potential");
BENCHMARK_CAPTURE(EndOfAction, potential_by_hand, "bench/tasks/potential_by_hand");
BENCHMARK(Observe);
BENCHMARK(ObserveByHand);
BENCHMARK(DrawStart);
BENCHMARK(DrawStartByHand);

}  // namespace
}  // namespace runtime

BENCHMARK_MAIN();
