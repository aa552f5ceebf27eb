#include "plugin_table.h"

static const taskc_log logs[] = {{"speed", "", "m/s", TASKC_MAX, {0, 3}},
                                 {"speed", "", "m/s", TASKC_MIN, {0, 4}}};

PLUGIN(.logs = logs, .log_count = 2)
