// A task without params.
#include "tests/runtime/core/task/plugins/plugin_table.h"

PLUGIN(.name = "bare", .robot = "")
