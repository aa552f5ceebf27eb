#include "plugin_table.h"

static void initialize(taskc_frame* frame) { (void)frame; }

static const taskc_phase phases[] = {{"reach", "", {0, 1}}};

PLUGIN(.phases = phases, .phase_count = 1, .memory_size = 16, .phase_offset = 8,
       .phase_time_offset = 16, .initialize = initialize)
