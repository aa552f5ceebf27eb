#include "plugin_table.h"

static void observe(taskc_frame* frame) { (void)frame; }

static const taskc_observation observations[] = {
    {"speed", "", "vec3", "m/s", TASKC_REAL, 3, 1, 1, 0, 1}};

PLUGIN(.observations = observations, .observation_count = 1, .observation_size = 3,
       .observe = observe)
