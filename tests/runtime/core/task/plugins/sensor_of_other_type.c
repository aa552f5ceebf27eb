#include "plugin_table.h"

static const taskc_sensor sensors[] = {
    {"base.velocity", "", "quat", "m/s", TASKC_REAL, 4, 1, 0, NO_RANGE}};

PLUGIN(.sensors = sensors, .sensor_count = 1)
