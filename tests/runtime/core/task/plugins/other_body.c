#include "plugin_table.h"

static const taskc_sensor sensors[] = {
    {"contact", "", "bool[link]", "", TASKC_BOOL, 18, 1, 0, NO_RANGE}};

PLUGIN(.sensors = sensors, .sensor_count = 1)
