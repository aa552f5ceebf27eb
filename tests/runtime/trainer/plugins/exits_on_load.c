// A shared object that ends the program while it is loaded.
#include <stdlib.h>

#include "tests/runtime/core/task/plugins/plugin_table.h"

__attribute__((constructor)) static void leave(void) { exit(0); }

PLUGIN(.name = "exits_on_load", .robot = "")
