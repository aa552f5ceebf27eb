#include "plugin_table.h"

static const taskc_sensor sensors[] = {{"base.velocty", "vec3", "m/s", TASKC_REAL, 3, 1, 0}};

PLUGIN(.sensors = sensors, .sensor_count = 1)
