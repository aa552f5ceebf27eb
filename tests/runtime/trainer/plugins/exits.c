// A task that ends the whole program, in its third time step.
#include <stdlib.h>

#include "tests/runtime/core/task/plugins/plugin_table.h"

#ifndef STATUS
#define STATUS 0
#endif

static void end_of_time_step(taskc_frame* frame) {
  taskc_int64* calls = (taskc_int64*)frame->memory;
  if (++*calls == 3) exit(STATUS);
}

static const taskc_memory variables[] = {{"calls", "int", "", TASKC_INT, 1, 1, TASKC_PER_RUN, 0}};

static void initialize(taskc_frame* frame) { *(taskc_int64*)frame->memory = 0; }

PLUGIN(.name = "exits", .robot = "", .memory = variables, .memory_count = 1, .memory_size = 8,
       .initialize = initialize, .events = {[TASKC_END_OF_TIME_STEP] = end_of_time_step})
