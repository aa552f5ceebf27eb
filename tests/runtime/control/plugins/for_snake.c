#include "tests/runtime/task/plugins/plugin_table.h"

PLUGIN(.robot = "snake")
