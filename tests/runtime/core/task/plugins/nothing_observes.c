#include "plugin_table.h"

static const taskc_observation observations[] = {
    {"speed", "", "real", "m/s", TASKC_REAL, 1, 1, 0, 0, 1}};

PLUGIN(.observations = observations, .observation_count = 1, .observation_size = 1)
