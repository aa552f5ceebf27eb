// Pays the distance that a ball has from the origin, along x.
#include "plugin_table.h"

static const taskc_sensor sensors[] = {
    {"ball.position", "", "vec3", "m", TASKC_REAL, 3, 1, 1 << TASKC_END_OF_TIME_STEP, NO_RANGE}};
static const taskc_reward_term terms[] = {{.name = "far", .doc = ""}};

static void EndTimeStep(taskc_frame* frame) {
  frame->reward = ((const double*)frame->sensors[0])[0];
}

PLUGIN(.sensors = sensors, .sensor_count = 1, .terms = terms, .term_count = 1,
       .events = {[TASKC_END_OF_TIME_STEP] = EndTimeStep})
