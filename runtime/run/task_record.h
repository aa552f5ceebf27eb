#pragma once

#include <taskc/plugin.h>

#include "runtime/run/run_records.h"

namespace runtime {

// Notes in `run` what the plugin says about its task: name, sources, compiler, terms, metrics and
// logs.
void DescribeTask(const taskc_plugin& plugin, RunRecord& run);

}  // namespace runtime
