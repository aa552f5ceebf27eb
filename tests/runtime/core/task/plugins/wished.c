// A task with sensors of its own of every kind. It pays the wish, 10 for each flag, the count times
// 100, and the last element of the place.
#include "plugin_table.h"

enum { WISH, FLAGS, COUNT, PLACE, SENSOR_COUNT };

static const taskc_sensor sensors[SENSOR_COUNT] = {
    {"wish", "", "real", "m/s", TASKC_REAL, 1, 1, 1u << TASKC_END_OF_TIME_STEP, -1, 2},
    {"flags", "", "bool[2]", "", TASKC_BOOL, 2, 1, 1u << TASKC_END_OF_TIME_STEP, NO_RANGE},
    {"count", "", "int", "", TASKC_INT, 1, 1, 1u << TASKC_END_OF_TIME_STEP, NO_RANGE},
    {"ball.place", "", "vec3", "m", TASKC_REAL, 3, 1, 1u << TASKC_END_OF_TIME_STEP, NO_RANGE},
};

static void end_of_time_step(taskc_frame* frame) {
  const unsigned char* flags = (const unsigned char*)frame->sensors[FLAGS];
  frame->reward = *(const double*)frame->sensors[WISH] + 10 * (flags[0] + flags[1]) +
                  100 * (double)*(const taskc_int64*)frame->sensors[COUNT] +
                  ((const double*)frame->sensors[PLACE])[2];
}

PLUGIN(.name = "wished", .sensors = sensors, .sensor_count = SENSOR_COUNT,
       .events = {[TASKC_END_OF_TIME_STEP] = end_of_time_step})
