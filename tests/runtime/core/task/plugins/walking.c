// A task that uses everything the ABI has: see universal_task_test.cpp for what it should do.
#include "plugin_table.h"

typedef struct memory {
  double paid;           // per episode
  taskc_int64 episodes;  // per run
  double kept[3];        // per run
  char fallen;           // per action
} memory;

enum { TIME, POSITION, VELOCITY, CONTACT, ANGLE, SENSOR_COUNT };
enum { GAIN, BONUS, STRICT, PARAM_COUNT };
enum { FORWARD, FALL, LAST_STEP, BENDING, TERM_COUNT };
enum { FAR_ENOUGH, TOO_FAST, TIME_IS_UP, AFTERWARDS, END_COUNT };
enum { LAST, SUM, MAX, MIN, MEAN, METRIC_COUNT };
enum { LOG_COUNT = 5 };
enum { NOT_TOO_FAST, NOT_FASTER, REQUIREMENT_COUNT };

static const double* reals(const taskc_frame* frame, int sensor) {
  return (const double*)frame->sensors[sensor];
}

static void pay(taskc_frame* frame, int term, double value) {
  if (!__builtin_isfinite(value)) {
    if (frame->fault < 0) frame->fault = term;
    return;
  }
  frame->reward += value;
  frame->terms[term] += value;
}

static void end(taskc_frame* frame, int index) {
  if (frame->end < 0) frame->end = index;
}

static void note(taskc_frame* frame, double value) {
  for (int log = 0; log < LOG_COUNT; ++log) {
    taskc_log_state* state = &frame->logs[log];
    const int is_first = state->count++ == 0;
    state->last = value;
    state->sum += value;
    if (is_first || value < state->minimum) state->minimum = value;
    if (is_first || value > state->maximum) state->maximum = value;
  }
}

static void require(taskc_frame* frame, int requirement, int holds) {
  if (!holds && frame->violation < 0) frame->violation = requirement;
}

static void initialize(taskc_frame* frame) {
  memory* m = (memory*)frame->memory;
  m->paid = 0;
  m->episodes = 100;
  m->kept[0] = m->kept[1] = m->kept[2] = 0.5;
  m->fallen = 0;
}

static void start_of_episode(taskc_frame* frame) {
  memory* m = (memory*)frame->memory;
  m->paid = 0;
  m->fallen = 0;
  m->episodes += 1;
}

static void start_of_action(taskc_frame* frame) {
  ((memory*)frame->memory)->fallen = 0;
  for (int joint = 0; joint < 2; ++joint) pay(frame, BENDING, reals(frame, ANGLE)[joint]);
}

static void end_of_time_step(taskc_frame* frame) {
  memory* m = (memory*)frame->memory;
  const char* contact = (const char*)frame->sensors[CONTACT];
  pay(frame, FORWARD, frame->params[GAIN] * reals(frame, VELOCITY)[0] * frame->time_step);
  if (reals(frame, VELOCITY)[0] > 0) note(frame, reals(frame, VELOCITY)[0]);
  require(frame, NOT_TOO_FAST, reals(frame, VELOCITY)[2] < 50);
  require(frame, NOT_FASTER, reals(frame, VELOCITY)[2] < 60);
  if (contact[2] && !m->fallen) {
    m->fallen = 1;
    pay(frame, FALL, -1);
  }
  m->paid += frame->reward;
  m->kept[2] += 1;
  if (reals(frame, VELOCITY)[1] > 5) end(frame, TOO_FAST);
  if (m->paid > 10) end(frame, FAR_ENOUGH);
  if (frame->params[STRICT] != 0 && contact[2]) end(frame, TIME_IS_UP);
}

static void end_of_physics_step(taskc_frame* frame) {
  pay(frame, LAST_STEP, frame->time_step + (double)((memory*)frame->memory)->episodes);
}

static void end_of_episode(taskc_frame* frame) {
  pay(frame, LAST_STEP, frame->params[BONUS]);
  end(frame, AFTERWARDS);
}

static void measure(taskc_frame* frame) {
  for (int i = 0; i < METRIC_COUNT; ++i) frame->metrics[i] = reals(frame, POSITION)[2];
  frame->metrics[LAST] = reals(frame, TIME)[0];
}

static const taskc_sensor sensors[SENSOR_COUNT] = {
    {"time", "", "real", "s", TASKC_REAL, 1, 1, 1u << TASKC_MEASURE, NO_RANGE},
    {"base.position", "", "vec3", "m", TASKC_REAL, 3, 1, 1u << TASKC_MEASURE, NO_RANGE},
    {"base.velocity", "", "vec3", "m/s", TASKC_REAL, 3, 1, 1u << TASKC_END_OF_TIME_STEP, NO_RANGE},
    {"contact", "", "bool[link]", "", TASKC_BOOL, 3, 1, 1u << TASKC_END_OF_TIME_STEP, NO_RANGE},
    {"joint.angle", "", "real[joint]", "rad", TASKC_REAL, 2, 1, 1u << TASKC_START_OF_ACTION,
     NO_RANGE},
};
static const taskc_param params[PARAM_COUNT] = {
    {"gain", "of the velocity", "", TASKC_REAL, 2, 0, 1000},
    {"bonus", "at the end", "", TASKC_INT, 3, -5, 5},
    {"strict", "ends with a fall", "", TASKC_BOOL, 0, 0, 1},
};
static const taskc_memory variables[] = {
    {"paid", "real", "", TASKC_REAL, 1, 1, TASKC_PER_EPISODE, offsetof(memory, paid)},
    {"episodes", "int", "", TASKC_INT, 1, 1, TASKC_PER_RUN, offsetof(memory, episodes)},
    {"kept", "vec3", "m", TASKC_REAL, 3, 1, TASKC_PER_RUN, offsetof(memory, kept)},
    {"fallen", "bool", "", TASKC_BOOL, 1, 1, TASKC_PER_ACTION, offsetof(memory, fallen)},
};
static const taskc_reward_term terms[TERM_COUNT] = {{"forward", "", {0, 10}},
                                                    {"fall", "", {0, 14}},
                                                    {"last_step", "", {0, 20}},
                                                    {"bending", "", {0, 25}}};
static const taskc_metric metrics[METRIC_COUNT] = {{"duration", "", "s", TASKC_LAST},
                                                   {"climbed", "", "m", TASKC_SUM},
                                                   {"highest", "", "m", TASKC_MAX},
                                                   {"lowest", "", "m", TASKC_MIN},
                                                   {"height", "", "m", TASKC_MEAN}};
static const taskc_end ends[END_COUNT] = {{"far enough", TASKC_SUCCESS, {0, 16}},
                                          {"too fast", TASKC_FAILURE, {0, 17}},
                                          {"time is up", TASKC_TRUNCATED, {0, 18}},
                                          {"afterwards", TASKC_SUCCESS, {0, 30}}};
static const taskc_log logs[LOG_COUNT] = {{"last_speed", "", "m/s", TASKC_LAST, {0, 40}},
                                          {"way", "", "m/s", TASKC_SUM, {0, 41}},
                                          {"fastest", "", "m/s", TASKC_MAX, {0, 42}},
                                          {"slowest", "", "m/s", TASKC_MIN, {0, 43}},
                                          {"speed", "", "m/s", TASKC_MEAN, {0, 44}}};
static const taskc_requirement requirements[REQUIREMENT_COUNT] = {{"not too fast", {0, 50}},
                                                                  {"not faster", {0, 51}}};

PLUGIN(.name = "walking", .sensors = sensors, .sensor_count = SENSOR_COUNT, .params = params,
       .param_count = PARAM_COUNT, .memory = variables, .memory_count = 4, .terms = terms,
       .term_count = TERM_COUNT, .metrics = metrics, .metric_count = METRIC_COUNT, .ends = ends,
       .end_count = END_COUNT, .logs = logs, .log_count = LOG_COUNT, .requirements = requirements,
       .requirement_count = REQUIREMENT_COUNT, .memory_size = sizeof(memory),
       .initialize = initialize, .measure = measure,
       .events = {[TASKC_START_OF_EPISODE] = start_of_episode,
                  [TASKC_END_OF_EPISODE] = end_of_episode,
                  [TASKC_START_OF_ACTION] = start_of_action,
                  [TASKC_END_OF_TIME_STEP] = end_of_time_step,
                  [TASKC_END_OF_PHYSICS_STEP] = end_of_physics_step})
