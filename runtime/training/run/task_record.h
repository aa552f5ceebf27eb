#pragma once

#include <taskc/plugin.h>

#include <string>

#include "runtime/training/run/run_records.h"

namespace runtime {

// What the plugin in the task module `module` says about its task. It has no id, and no file in a
// run's folder, yet.
TaskRecord DescribeTask(const taskc_plugin& plugin, std::string module);

}  // namespace runtime
