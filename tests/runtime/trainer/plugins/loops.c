// A task that does not come back.
#include "tests/runtime/core/task/plugins/plugin_table.h"

static void end_of_time_step(taskc_frame* frame) {
  for (volatile int forever = 1; forever;) frame->reward = 0;
}

PLUGIN(.name = "loops", .robot = "", .events = {[TASKC_END_OF_TIME_STEP] = end_of_time_step})
