// Errors, tasks, and making and binding instances.
#include <taskc/host.h>

#include "libtaskc/failure.h"
#include "libtaskc/instance.h"

using libtaskc::Guarded;
using libtaskc::RequirePointer;

const char* taskc_error(void) { return libtaskc::KeptMessage(); }

taskc_uint32 taskc_abi_version(void) { return TASKC_ABI_VERSION; }

taskc_status taskc_open(const char* file, taskc_task** task) {
  return Guarded([&] {
    RequirePointer(file, "the name of the file");
    RequirePointer(task, "the place for the task");
    *task = new taskc_task{std::make_shared<const host::Plugin>(file)};
  });
}

void taskc_close(taskc_task* task) { delete task; }

const taskc_plugin* taskc_describe(const taskc_task* task) {
  return task == nullptr ? nullptr : &task->plugin->table();
}

taskc_status taskc_new_instance(const taskc_task* task, taskc_instance** instance) {
  return Guarded([&] {
    RequirePointer(task, "the task");
    RequirePointer(instance, "the place for the instance");
    *instance = new taskc_instance(task->plugin);
  });
}

void taskc_delete_instance(taskc_instance* instance) { delete instance; }

taskc_status taskc_bind(taskc_instance* instance, const char* sensor, const char* unit,
                        taskc_view view) {
  return Guarded([&] {
    RequirePointer(instance, "the instance");
    instance->sensors.Bind(sensor, unit, view);
  });
}

taskc_status taskc_bind_function(taskc_instance* instance, const char* sensor, const char* unit,
                                 taskc_sensor_function function, void* user) {
  return Guarded([&] {
    RequirePointer(instance, "the instance");
    instance->sensors.BindFunction(sensor, unit, function, user);
  });
}
