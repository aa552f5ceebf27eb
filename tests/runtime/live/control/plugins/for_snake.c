#include "tests/runtime/core/task/plugins/plugin_table.h"

PLUGIN(.robot = "snake")
