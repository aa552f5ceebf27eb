// A shared object that never has been loaded.
#include "tests/runtime/core/task/plugins/plugin_table.h"

__attribute__((constructor)) static void loop(void) {
  for (volatile int forever = 1; forever;) {
  }
}

PLUGIN(.name = "loops_on_load", .robot = "")
