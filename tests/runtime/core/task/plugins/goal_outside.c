#include "plugin_table.h"

static void initialize(taskc_frame* frame) { (void)frame; }

static const taskc_goal goals[] = {{"place", "", "real", "m", TASKC_REAL, 1, 1, 0, 8, 24}};

PLUGIN(.goals = goals, .goal_count = 1, .memory_size = 24, .initialize = initialize)
