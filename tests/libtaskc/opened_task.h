// Tasks and instances that end with the test.
#pragma once

#include <gtest/gtest.h>
#include <taskc/host.h>

#include <string>

namespace libtaskc {

inline std::string PluginFile(const std::string& name) {
  return std::string(TASK_FOLDER) + "/" + name + ".so";
}

class OpenedTask {
 public:
  explicit OpenedTask(const std::string& name) {
    EXPECT_EQ(taskc_open(PluginFile(name).c_str(), &task_), TASKC_OK) << taskc_error();
  }
  ~OpenedTask() { taskc_close(task_); }
  OpenedTask(const OpenedTask&) = delete;
  OpenedTask& operator=(const OpenedTask&) = delete;

  taskc_task* get() const { return task_; }
  const taskc_plugin& table() const { return *taskc_describe(task_); }

 private:
  taskc_task* task_ = nullptr;
};

class Instance {
 public:
  explicit Instance(const OpenedTask& task) {
    EXPECT_EQ(taskc_new_instance(task.get(), &instance_), TASKC_OK) << taskc_error();
  }
  ~Instance() { taskc_delete_instance(instance_); }
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  taskc_instance* get() const { return instance_; }
  operator taskc_instance*() const { return instance_; }  // NOLINT(google-explicit-constructor)

 private:
  taskc_instance* instance_ = nullptr;
};

// What the task `each` reads, as a host may have it.
struct World {
  double place[3] = {1, 0, 0.5};
  float turn[4] = {0.25F, 0.5F, 0.75F, 0};  // x, y, z, w
  taskc_int32 steps = 0;
  double touches[3] = {0, 0, 0};
};

inline void Bind(taskc_instance* instance, const World& world) {
  EXPECT_EQ(taskc_bind(instance, "place", "m", {.data = world.place, .format = TASKC_FLOAT64}), 0)
      << taskc_error();
  EXPECT_EQ(taskc_bind(instance, "turn", "",
                       {.data = world.turn, .format = TASKC_FLOAT32, .quaternions = TASKC_XYZW}),
            0)
      << taskc_error();
  EXPECT_EQ(taskc_bind(instance, "steps", nullptr, {.data = &world.steps, .format = TASKC_INT32}),
            0)
      << taskc_error();
  EXPECT_EQ(
      taskc_bind(instance, "touches", nullptr, {.data = world.touches, .format = TASKC_FLOAT64}), 0)
      << taskc_error();
}

}  // namespace libtaskc
