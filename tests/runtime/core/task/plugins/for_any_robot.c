#include "plugin_table.h"

static const taskc_sensor sensors[] = {
    {"contact", "", "bool[3]", "", TASKC_BOOL, 3, 1, 0, NO_RANGE},
    {"link.position", "", "vec3[3]", "m", TASKC_REAL, 3, 3, 0, NO_RANGE},
    {"base.velocity", "", "vec3", "m/s", TASKC_REAL, 3, 1, 0, NO_RANGE}};

PLUGIN(.robot = "", .sensors = sensors, .sensor_count = 3)
