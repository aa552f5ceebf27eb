#include "plugin_table.h"

static const taskc_sensor sensors[] = {{"time", "", "real", "s", 7, 1, 1, 0, NO_RANGE}};

PLUGIN(.sensors = sensors, .sensor_count = 1)
