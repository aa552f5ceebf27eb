#include "plugin_table.h"

static const taskc_sensor sensors[] = {
    {"ball.position", "", "vec3", "m", TASKC_REAL, 5, 1, 0, NO_RANGE}};

PLUGIN(.sensors = sensors, .sensor_count = 1)
