// A task with goals: each draw of `place` is (the lower half of the seed, how often it was drawn
// before in this episode), and each of `side` is 1.
#include "plugin_table.h"

typedef struct memory {
  double place[2];
  taskc_int64 place_draws;
  taskc_int64 side;
  taskc_int64 side_draws;
  char place_held;
  char side_held;
} memory;

static void draw_place(taskc_frame* frame) {
  memory* m = (memory*)frame->memory;
  if (m->place_held) return;
  m->place[0] = (double)(taskc_uint32)frame->seed;
  m->place[1] = (double)m->place_draws;
  ++m->place_draws;
}

static void draw_side(taskc_frame* frame) {
  memory* m = (memory*)frame->memory;
  if (m->side_held) return;
  m->side = 1;
  ++m->side_draws;
}

static void initialize(taskc_frame* frame) {
  *(memory*)frame->memory = (memory){{0, 0}, 0, 0, 0, 0, 0};
  draw_place(frame);
  draw_side(frame);
}

static void start_of_episode(taskc_frame* frame) {
  memory* m = (memory*)frame->memory;
  m->place_draws = 0;
  m->side_draws = 0;
  draw_place(frame);
  draw_side(frame);
}

static void end_of_time_step(taskc_frame* frame) { draw_place(frame); }

static const taskc_memory variables[] = {
    {"place", "vec2", "m", TASKC_REAL, 2, 1, TASKC_PER_RUN, offsetof(memory, place)},
    {"place#held", "bool", "", TASKC_BOOL, 1, 1, TASKC_PER_RUN, offsetof(memory, place_held)},
    {"place#draws", "int", "", TASKC_INT, 1, 1, TASKC_PER_EPISODE, offsetof(memory, place_draws)},
    {"side", "int", "", TASKC_INT, 1, 1, TASKC_PER_RUN, offsetof(memory, side)},
    {"side#held", "bool", "", TASKC_BOOL, 1, 1, TASKC_PER_RUN, offsetof(memory, side_held)},
    {"side#draws", "int", "", TASKC_INT, 1, 1, TASKC_PER_EPISODE, offsetof(memory, side_draws)},
};
static const taskc_goal goals[] = {
    {"place", "where to go", "vec2", "m", TASKC_REAL, 2, 1, offsetof(memory, place),
     offsetof(memory, place_held), offsetof(memory, place_draws)},
    {"side", "", "int", "", TASKC_INT, 1, 1, offsetof(memory, side), offsetof(memory, side_held),
     offsetof(memory, side_draws)},
};

PLUGIN(.name = "told", .memory = variables, .memory_count = 6, .goals = goals, .goal_count = 2,
       .memory_size = sizeof(memory), .initialize = initialize,
       .events = {[TASKC_START_OF_EPISODE] = start_of_episode,
                  [TASKC_END_OF_TIME_STEP] = end_of_time_step})
