// A task in which each time step pays 1 and leads to the phase with number 1.
#include "plugin_table.h"

typedef struct memory {
  taskc_int64 phase;
  double time;
} memory;

static void initialize(taskc_frame* frame) { *(memory*)frame->memory = (memory){0, 0}; }

static void end_of_time_step(taskc_frame* frame) {
  memory* m = (memory*)frame->memory;
  m->time += frame->time_step;
  if (m->phase != 1) *m = (memory){1, 0};
  frame->reward = 1;
}

static const taskc_memory variables[] = {
    {"phase#", "int", "", TASKC_INT, 1, 1, TASKC_PER_EPISODE, offsetof(memory, phase)},
    {"phase_time", "real", "s", TASKC_REAL, 1, 1, TASKC_PER_EPISODE, offsetof(memory, time)},
};

#define PHASED(...)                                                                            \
  PLUGIN(__VA_ARGS__, .memory = variables, .memory_count = 2, .memory_size = sizeof(memory),   \
         .phase_offset = offsetof(memory, phase), .phase_time_offset = offsetof(memory, time), \
         .initialize = initialize,                                                             \
         .events = {                                                                           \
             [TASKC_START_OF_EPISODE] = initialize, [TASKC_END_OF_TIME_STEP] = end_of_time_step})
