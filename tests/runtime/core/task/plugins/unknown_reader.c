#include "plugin_table.h"

static const taskc_sensor sensors[] = {
    {"time", "", "real", "s", TASKC_REAL, 1, 1, 1u << 12, NO_RANGE}};

PLUGIN(.sensors = sensors, .sensor_count = 1)
