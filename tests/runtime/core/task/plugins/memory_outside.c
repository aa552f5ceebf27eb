#include "plugin_table.h"

static void initialize(taskc_frame* frame) { (void)frame; }
static const taskc_memory memory[] = {{"sums", "vec3", "", TASKC_REAL, 3, 1, TASKC_PER_EPISODE, 8}};

PLUGIN(.memory = memory, .memory_count = 1, .memory_size = 24, .initialize = initialize)
