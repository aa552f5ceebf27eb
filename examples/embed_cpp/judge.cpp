// A host in C++: it has recorded episodes, and lets a task judge them all, in several threads.
//
//   cmake -B build -DCMAKE_PREFIX_PATH=PREFIX && cmake --build build && build/judge build/docking.so
//
// PREFIX is where taskc was installed to.
#include <taskc/host.h>

#include <array>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <vector>

namespace {

constexpr double kTimeStep = 0.02;  // [s]

void Check(taskc_status status) {
  if (status != TASKC_OK) throw std::runtime_error(taskc_error());
}

struct Deleter {
  void operator()(taskc_task* task) const { taskc_close(task); }
  void operator()(taskc_instance* instance) const { taskc_delete_instance(instance); }
};
using Task = std::unique_ptr<taskc_task, Deleter>;
using Instance = std::unique_ptr<taskc_instance, Deleter>;

Task Open(const char* file) {
  taskc_task* task = nullptr;
  Check(taskc_open(file, &task));
  return Task(task);
}

Instance InstanceOf(const Task& task) {
  taskc_instance* instance = nullptr;
  Check(taskc_new_instance(task.get(), &instance));
  return Instance(instance);
}

// What the host keeps of each time step: more than this task reads, in an order of its own.
struct Row {
  float time;
  std::array<float, 2> position;
  std::array<float, 2> velocity;
};
using Episode = std::vector<Row>;

// A cart that starts off the dock, and is pulled to it by a spring and a damper.
Episode Drive(float start, float damping) {
  Episode episode;
  Row row{0, {start, -start}, {0, 0}};
  for (int step = 0; step < 1000; ++step) {
    const float dt = kTimeStep;
    for (int i = 0; i < 2; ++i) {
      row.velocity[i] += (-2 * row.position[i] - damping * row.velocity[i]) * dt;
      row.position[i] += row.velocity[i] * dt;
    }
    row.time += dt;
    episode.push_back(row);
  }
  return episode;
}

taskc_column ColumnOf(const char* sensor, const char* unit, const std::array<float, 2>& first) {
  taskc_column column{};
  column.sensor = sensor;
  column.unit = unit;
  column.view.data = first.data();
  column.view.format = TASKC_FLOAT32;
  column.time_stride = sizeof(Row);
  return column;
}

void Judge(const char* plugin) {
  const std::vector<Episode> episodes = {Drive(1, 3), Drive(1, 0.2F), Drive(4, 3)};
  std::vector<std::array<taskc_column, 2>> columns;
  for (const Episode& episode : episodes) {
    columns.push_back({ColumnOf("cart.position", "m", episode.front().position),
                       ColumnOf("cart.velocity", "m/s", episode.front().velocity)});
  }
  std::vector<taskc_recording> recordings;
  for (size_t i = 0; i < episodes.size(); ++i) {
    taskc_recording recording{};
    recording.columns = columns[i].data();
    recording.column_count = 2;
    recording.rows = static_cast<taskc_int64>(episodes[i].size());
    recording.time_step = kTimeStep;
    recordings.push_back(recording);
  }

  const Task task = Open(plugin);
  const Instance instance = InstanceOf(task);
  Check(taskc_set_param(instance.get(), "reach", "m", 1));
  std::vector<double> distances(episodes.size());
  std::vector<taskc_evaluation> evaluations(episodes.size());
  for (size_t i = 0; i < episodes.size(); ++i) evaluations[i].metrics = &distances[i];
  Check(taskc_evaluate(instance.get(), recordings.data(), recordings.size(), 0, evaluations.data()));

  const taskc_plugin& about = *taskc_describe(task.get());
  for (size_t i = 0; i < evaluations.size(); ++i) {
    const taskc_evaluation& evaluation = evaluations[i];
    std::printf("episode %zu: return %.3f in %lld steps, %.2f m from the dock: %s\n", i + 1,
                evaluation.episode_return, evaluation.time_steps, distances[i],
                evaluation.end < 0 ? "not over" : about.ends[evaluation.end].reason);
  }
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::fprintf(stderr, "usage: judge PLUGIN.so\n");
    return 2;
  }
  Judge(argv[1]);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "judge: %s\n", error.what());
  return 1;
}
