#include "plugin_table.h"

static const taskc_sensor sensors[] = {
    {"base.velocity", "", "vec3", "m", TASKC_REAL, 3, 1, 0, NO_RANGE}};

PLUGIN(.sensors = sensors, .sensor_count = 1)
