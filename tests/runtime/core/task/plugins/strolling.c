// A task that shares some of its variables with `walking`, under the same names.
#include "plugin_table.h"

typedef struct memory {
  double speed;          // per run; `walking` does not have it
  taskc_int64 episodes;  // per run, the same
  double kept;           // per run, of another type
  double paid;           // per episode, the same
} memory;

static void initialize(taskc_frame* frame) {
  memory* m = (memory*)frame->memory;
  m->speed = 7;
  m->episodes = 1000;
  m->kept = 8;
  m->paid = 0;
}

static void end_of_time_step(taskc_frame* frame) {
  memory* m = (memory*)frame->memory;
  const double* up = (const double*)frame->sensors[0];
  frame->reward = frame->params[0] + up[2];
  frame->terms[1] += frame->reward;
  m->paid += frame->reward;
  if (m->paid > 1000) frame->end = 0;
}

// All that it remembers and knows, as digits.
static void end_of_action(taskc_frame* frame) {
  const memory* m = (const memory*)frame->memory;
  frame->reward = m->speed + 10 * m->kept + 100 * frame->params[1] + 1000 * m->paid +
                  1000000 * (double)m->episodes;
}

static void end_of_episode(taskc_frame* frame) { frame->reward = 0.5; }

static void measure(taskc_frame* frame) {
  frame->metrics[0] = 1;
  frame->metrics[1] = ((const double*)frame->sensors[0])[2];
}

static const taskc_sensor sensors[] = {
    {"base.up", "", "vec3", "", TASKC_REAL, 3, 1,
     1u << TASKC_END_OF_TIME_STEP | 1u << TASKC_MEASURE, NO_RANGE},
    {"base.velocity", "", "vec3", "m/s", TASKC_REAL, 3, 1, 1u << TASKC_END_OF_TIME_STEP, NO_RANGE},
};
static const taskc_param params[] = {
    {"gain", "", "", TASKC_REAL, 0.25, 0, 50},
    {"bonus", "", "", TASKC_INT, 4, -5, 5},
    {"strict", "not what `walking` has", "", TASKC_REAL, 0, 0, 1},
};
static const taskc_memory variables[] = {
    {"speed", "real", "", TASKC_REAL, 1, 1, TASKC_PER_RUN, offsetof(memory, speed)},
    {"episodes", "int", "", TASKC_INT, 1, 1, TASKC_PER_RUN, offsetof(memory, episodes)},
    {"kept", "real", "m", TASKC_REAL, 1, 1, TASKC_PER_RUN, offsetof(memory, kept)},
    {"paid", "real", "", TASKC_REAL, 1, 1, TASKC_PER_EPISODE, offsetof(memory, paid)},
};
static const taskc_reward_term terms[] = {{"forward", "", {0, 10}}, {"stroll", "", {0, 11}}};
static const taskc_metric metrics[] = {{"steps", "", "", TASKC_SUM},
                                       {"height", "", "m", TASKC_MEAN}};
static const taskc_end ends[] = {{"paid enough", TASKC_SUCCESS, {0, 16}}};

PLUGIN(.name = "strolling", .sensors = sensors, .sensor_count = 2, .params = params,
       .param_count = 3, .memory = variables, .memory_count = 4, .terms = terms, .term_count = 2,
       .metrics = metrics, .metric_count = 2, .ends = ends, .end_count = 1,
       .memory_size = sizeof(memory), .initialize = initialize, .measure = measure,
       .events = {[TASKC_END_OF_TIME_STEP] = end_of_time_step,
                  [TASKC_END_OF_ACTION] = end_of_action,
                  [TASKC_END_OF_EPISODE] = end_of_episode})
