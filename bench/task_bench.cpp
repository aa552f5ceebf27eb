// What a time step costs with each of the six tasks, besides physics and learning:
//   Sensing    the sensors that the task reads at the end of every time step, out of the simulation
//   Callback   the task's end_of_time_step on them
// and what functions of the past, a goal and phases cost, beside the same written out with memory,
// and what tables cost, beside the same in C++.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

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
      : world_(Humanoid(), FindProfile("fast-tree"), Humanoid().poses[0]), sensors_(Humanoid()) {
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

void Callback(benchmark::State& state, const char* task) {
  const taskc_plugin& plugin = LoadTask(task).table();
  Scene scene(plugin);
  host::TaskFrame frame(plugin);
  scene.Bind(frame);
  frame.Initialize();
  const taskc_event_function callback = plugin.events[TASKC_END_OF_TIME_STEP];
  for (auto _ : state) {
    benchmark::ClobberMemory();
    callback(frame.Next(0.005));
    benchmark::DoNotOptimize(frame.frame().reward);
  }
}

// On the same sensors; without what a callback does for every task.
void TableByHand(benchmark::State& state) {
  const taskc_plugin& plugin = LoadTask("bench/tasks/table").table();
  Scene scene(plugin);
  host::TaskFrame frame(plugin);
  scene.Bind(frame);
  static const MotionByHand motion(SOURCE_DIR "/examples/tasks/track.csv");
  const auto sensor = [&](std::string_view name) {
    for (taskc_uint32 i = 0; i < plugin.sensor_count; ++i)
      if (plugin.sensors[i].name == name) return static_cast<const double*>(frame.sensor(i));
    throw std::runtime_error("the task lacks a sensor");
  };
  const double* time = sensor("time");
  const double* angles = sensor("joint.angle");
  const double* positions = sensor("link.position");
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

}  // namespace
}  // namespace runtime

BENCHMARK_MAIN();
