#include "plugin_table.h"

static const taskc_log logs[] = {{"speed", "", NULL, TASKC_MAX, {0, 3}}};

PLUGIN(.logs = logs, .log_count = 1)
