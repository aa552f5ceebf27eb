// A task that does what no task of taskc does: it writes where nothing is, in its third time step.
#include "tests/runtime/core/task/plugins/plugin_table.h"

static void end_of_time_step(taskc_frame* frame) {
  taskc_int64* steps = (taskc_int64*)frame->memory;
  if (++*steps == 3) *(volatile int*)8 = 1;
}

static const taskc_memory variables[] = {{"steps", "int", "", TASKC_INT, 1, 1, TASKC_PER_RUN, 0}};

static void initialize(taskc_frame* frame) { *(taskc_int64*)frame->memory = 0; }

PLUGIN(.name = "crashes", .robot = "", .memory = variables, .memory_count = 1, .memory_size = 8,
       .initialize = initialize, .events = {[TASKC_END_OF_TIME_STEP] = end_of_time_step})
