// What a task costs through libtaskc:
//   Evaluate   recorded episodes of 4,000 time steps, as items a second: where all numbers lie as
//   the
//              task has them; EvaluateSingle: where they are single precision
//   Event      one time step of an instance whose sensors are bound
#include <benchmark/benchmark.h>
#include <taskc/host.h>

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

constexpr taskc_int64 kRows = 4000;
constexpr double kTimeStep = 0.005;

void Check(taskc_status status) {
  if (status != TASKC_OK) throw std::runtime_error(taskc_error());
}

class OpenTask {
 public:
  explicit OpenTask(const std::string& name) {
    Check(taskc_open((std::string(TASKS) + "/" + name + ".so").c_str(), &task_));
    Check(taskc_new_instance(task_, &instance_));
  }
  ~OpenTask() {
    taskc_delete_instance(instance_);
    taskc_close(task_);
  }
  OpenTask(const OpenTask&) = delete;
  OpenTask& operator=(const OpenTask&) = delete;

  taskc_instance* instance() const { return instance_; }
  std::span<const taskc_sensor> sensors() const {
    const taskc_plugin& table = *taskc_describe(task_);
    return {table.sensors, table.sensor_count};
  }

 private:
  taskc_task* task_ = nullptr;
  taskc_instance* instance_ = nullptr;
};

// An episode in which everything moves a little, and no link touches the ground.
template <class Number>
class Motion {
 public:
  Motion(std::span<const taskc_sensor> sensors, taskc_int32 format) {
    for (const taskc_sensor& sensor : sensors) {
      const size_t size = size_t{sensor.rows} * sensor.columns;
      const bool is_bool = sensor.scalar == TASKC_BOOL;
      std::vector<Number>& numbers = numbers_.emplace_back(is_bool ? 0 : size * kRows);
      std::vector<unsigned char>& flags = flags_.emplace_back(is_bool ? size * kRows : 0);
      for (size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<Number>(i % 7) / 1000;
      taskc_column column{};
      column.sensor = sensor.name;
      column.view.data = is_bool ? static_cast<void*>(flags.data()) : numbers.data();
      column.view.format = is_bool ? TASKC_BOOL8 : format;
      column.time_stride = static_cast<ptrdiff_t>(size * (is_bool ? 1 : sizeof(Number)));
      columns_.push_back(column);
    }
  }
  std::span<const taskc_column> columns() const { return columns_; }

 private:
  std::vector<std::vector<Number>> numbers_;
  std::vector<std::vector<unsigned char>> flags_;
  std::vector<taskc_column> columns_;
};

template <class Number>
void EvaluateAs(benchmark::State& state, const char* task, taskc_int32 format) {
  const OpenTask opened(task);
  const Motion<Number> motion(opened.sensors(), format);
  taskc_recording recording{};
  recording.columns = motion.columns().data();
  recording.column_count = static_cast<taskc_uint32>(motion.columns().size());
  recording.rows = kRows;
  recording.time_step = kTimeStep;
  recording.action_length = 40;
  const std::vector<taskc_recording> recordings(16, recording);
  std::vector<taskc_evaluation> evaluations(recordings.size());
  taskc_int64 steps = 0;
  for (auto _ : state) {
    Check(taskc_evaluate(opened.instance(), recordings.data(), recordings.size(), 1,
                         evaluations.data()));
    for (const taskc_evaluation& evaluation : evaluations) steps += evaluation.time_steps;
  }
  state.SetItemsProcessed(steps);
}

void Evaluate(benchmark::State& state, const char* task) {
  EvaluateAs<double>(state, task, TASKC_FLOAT64);
}

void EvaluateSingle(benchmark::State& state, const char* task) {
  EvaluateAs<float>(state, task, TASKC_FLOAT32);
}

void Event(benchmark::State& state, const char* task) {
  const OpenTask opened(task);
  const Motion<double> motion(opened.sensors(), TASKC_FLOAT64);
  for (const taskc_column& column : motion.columns())
    Check(taskc_bind(opened.instance(), column.sensor, nullptr, column.view));
  Check(taskc_start_episode(opened.instance(), 1, nullptr));
  for (auto _ : state) {
    taskc_result result;
    benchmark::ClobberMemory();
    Check(taskc_event(opened.instance(), TASKC_END_OF_TIME_STEP, kTimeStep, &result));
    benchmark::DoNotOptimize(result.reward);
  }
}

BENCHMARK_CAPTURE(Evaluate, crawling, "crawling");
BENCHMARK_CAPTURE(Evaluate, turning, "turning");
BENCHMARK_CAPTURE(EvaluateSingle, crawling, "crawling");
BENCHMARK_CAPTURE(Event, crawling, "crawling");
BENCHMARK_CAPTURE(Event, turning, "turning");

}  // namespace

BENCHMARK_MAIN();
