// A shared object whose code runs, and fails, before anyone can ask what it is.
#include "tests/runtime/core/task/plugins/plugin_table.h"

__attribute__((constructor)) static void crash(void) { *(volatile int*)8 = 1; }

PLUGIN(.name = "crashes_on_load", .robot = "")
