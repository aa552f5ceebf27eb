// A task that observes the time, and 1 over each element of the velocity.
#include "plugin_table.h"

static void observe(taskc_frame* frame) {
  const double* velocity = (const double*)frame->sensors[1];
  frame->observations[0] = *(const double*)frame->sensors[0];
  for (int i = 0; i < 3; ++i) frame->observations[1 + i] = 1 / velocity[i];
}

static void end_of_time_step(taskc_frame* frame) { frame->reward = 1; }

static const taskc_sensor sensors[] = {
    {"time", "", "real", "s", TASKC_REAL, 1, 1, 1u << TASKC_OBSERVE, NO_RANGE},
    {"base.velocity", "", "vec3", "m/s", TASKC_REAL, 3, 1, 1u << TASKC_OBSERVE, NO_RANGE}};
static const taskc_observation observations[] = {
    {"time", "", "real", "s", TASKC_REAL, 1, 1, 0, 0, 20},
    {"slowness", "of the base", "vec3", "s/m", TASKC_REAL, 3, 1, 1, -1e30, 1e30}};

PLUGIN(.name = "seeing", .sensors = sensors, .sensor_count = 2, .observations = observations,
       .observation_count = 2, .observation_size = 4, .observe = observe,
       .events = {[TASKC_END_OF_TIME_STEP] = end_of_time_step})
