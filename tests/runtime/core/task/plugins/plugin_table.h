// The table of a task that does nothing, for the robot of these tests. PLUGIN(.field = value, ...)
// defines and exports it with some fields changed.
#include <math.h>
#include <stddef.h>
#include <taskc/plugin.h>

#define NO_RANGE -HUGE_VAL, HUGE_VAL  // minimum and maximum of a sensor

#define PLUGIN(...)                                                                   \
  static const taskc_source sources[] = {{"test.task", ""}};                          \
  static const taskc_plugin plugin = {.abi_version = TASKC_ABI_VERSION,               \
                                      .struct_size = sizeof(taskc_plugin),            \
                                      .compiler = "by hand",                          \
                                      .name = "test",                                 \
                                      .doc = "",                                      \
                                      .robot = "walker",                              \
                                      .sources = sources,                             \
                                      .source_count = 1,                              \
                                      .source_hash = "",                              \
                                      __VA_ARGS__};                                   \
  __attribute__((visibility("default"))) const taskc_plugin* taskc_plugin_get(void) { \
    return &plugin;                                                                   \
  }
