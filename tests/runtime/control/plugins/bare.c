// A task without params.
#include "tests/runtime/task/plugins/plugin_table.h"

PLUGIN(.name = "bare", .robot = "")
