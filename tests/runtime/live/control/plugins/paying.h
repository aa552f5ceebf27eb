// A task for any robot that pays per second, counts its episodes, ends when its time is up, and has
// a goal that depends on the seed, and two phases. With SEES it observes how much of its time has
// passed. To be included with NAME defined.
#include "tests/runtime/core/task/plugins/plugin_table.h"

typedef struct memory {
  taskc_int64 episodes;  // per run
  double time;           // [s], per episode
  double aim[2];
  taskc_int64 aim_draws;
  taskc_int64 phase;
  double phase_time;
  char aim_held;
} memory;

enum { GAIN, LIMIT, COUNT, PARAM_COUNT };

static void draw_aim(taskc_frame* frame) {
  memory* m = (memory*)frame->memory;
  if (m->aim_held) return;
  m->aim[0] = (double)(frame->seed % 1000);
  m->aim[1] = (double)m->aim_draws;
  ++m->aim_draws;
}

static void initialize(taskc_frame* frame) {
  memory* m = (memory*)frame->memory;
  *m = (memory){0, 0, {0, 0}, 0, 0, 0, 0};
  draw_aim(frame);
}

static void start_of_episode(taskc_frame* frame) {
  memory* m = (memory*)frame->memory;
  m->episodes += 1;
  m->time = 0;
  m->phase = 0;
  m->phase_time = 0;
  m->aim_draws = 0;
  draw_aim(frame);
}

static void end_of_time_step(taskc_frame* frame) {
  memory* m = (memory*)frame->memory;
  m->time += frame->time_step;
  frame->reward = frame->params[GAIN] * frame->time_step;
  frame->terms[0] += frame->reward;
  m->phase_time += frame->time_step;
  if (m->phase == 0 && m->phase_time > 0.0199) {
    m->phase = 1;
    m->phase_time = 0;
  }
  if (m->time > frame->params[LIMIT]) frame->end = 0;
}

static void measure(taskc_frame* frame) {
  frame->metrics[0] = (double)((const memory*)frame->memory)->episodes;
}

static const taskc_sensor sensors[] = {
    {"time", "", "real", "s", TASKC_REAL, 1, 1, 1u << TASKC_END_OF_TIME_STEP, NO_RANGE}};
static const taskc_param params[PARAM_COUNT] = {
    {"gain", "per second", "", TASKC_REAL, 1, 0, 10},
    {"limit", "of the time", "s", TASKC_REAL, 0.0999, 0.001, 10},
    {"count", "of nothing", "", TASKC_INT, 3, 0, 100},
};
static const taskc_memory variables[] = {
    {"episodes", "int", "", TASKC_INT, 1, 1, TASKC_PER_RUN, offsetof(memory, episodes)},
    {"time", "real", "s", TASKC_REAL, 1, 1, TASKC_PER_EPISODE, offsetof(memory, time)},
    {"aim", "vec2", "m", TASKC_REAL, 2, 1, TASKC_PER_RUN, offsetof(memory, aim)},
    {"aim#held", "bool", "", TASKC_BOOL, 1, 1, TASKC_PER_RUN, offsetof(memory, aim_held)},
    {"phase#", "int", "", TASKC_INT, 1, 1, TASKC_PER_EPISODE, offsetof(memory, phase)},
    {"phase_time", "real", "s", TASKC_REAL, 1, 1, TASKC_PER_EPISODE, offsetof(memory, phase_time)},
    {"aim#draws", "int", "", TASKC_INT, 1, 1, TASKC_PER_EPISODE, offsetof(memory, aim_draws)},
};
static const taskc_goal goals[] = {{"aim", "where to", "vec2", "m", TASKC_REAL, 2, 1,
                                    offsetof(memory, aim), offsetof(memory, aim_held),
                                    offsetof(memory, aim_draws)}};
static const taskc_phase phases[] = {{"early", "20 ms", {0, 11}}, {"late", "", {0, 12}}};
static const taskc_reward_term terms[] = {{"presence", "", {0, 10}}};
static const taskc_metric metrics[] = {{"episodes", "", "", TASKC_LAST}};
static const taskc_end ends[] = {{"time is up", TASKC_TRUNCATED, {0, 16}}};

#ifdef SEES
static void observe(taskc_frame* frame) {
  frame->observations[0] = ((const memory*)frame->memory)->time;
}
static const taskc_observation observations[] = {
    {"elapsed", "", "real", "s", TASKC_REAL, 1, 1, 0, 0, 20}};
#define OBSERVATIONS \
  , .observations = observations, .observation_count = 1, .observation_size = 1, .observe = observe
#else
#define OBSERVATIONS
#endif

PLUGIN(.name = NAME, .robot = "", .sensors = sensors, .sensor_count = 1, .params = params,
       .param_count = PARAM_COUNT, .memory = variables, .memory_count = 7, .goals = goals,
       .goal_count = 1, .phases = phases, .phase_count = 2, .phase_offset = offsetof(memory, phase),
       .phase_time_offset = offsetof(memory, phase_time), .terms = terms, .term_count = 1,
       .metrics = metrics, .metric_count = 1, .ends = ends, .end_count = 1,
       .memory_size = sizeof(memory), .initialize = initialize, .measure = measure,
       .events = {[TASKC_START_OF_EPISODE] = start_of_episode,
                  [TASKC_END_OF_TIME_STEP] = end_of_time_step} OBSERVATIONS)
