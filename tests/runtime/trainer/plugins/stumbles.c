// A task that does what no task of taskc does: it writes where nothing is, in the third time step
// of each episode. It remembers none of them.
#include "tests/runtime/core/task/plugins/plugin_table.h"

static void start_of_episode(taskc_frame* frame) { *(taskc_int64*)frame->memory = 0; }

static void end_of_time_step(taskc_frame* frame) {
  taskc_int64* steps = (taskc_int64*)frame->memory;
  if (++*steps == 3) *(volatile int*)8 = 1;
}

static const taskc_memory variables[] = {
    {"steps", "int", "", TASKC_INT, 1, 1, TASKC_PER_EPISODE, 0}};

PLUGIN(.name = "stumbles", .robot = "", .memory = variables, .memory_count = 1, .memory_size = 8,
       .initialize = start_of_episode,
       .events = {[TASKC_START_OF_EPISODE] = start_of_episode,
                  [TASKC_END_OF_TIME_STEP] = end_of_time_step})
