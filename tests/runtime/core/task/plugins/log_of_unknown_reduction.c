#include "plugin_table.h"

static const taskc_log logs[] = {{"speed", "", "m/s", -1, {0, 3}}};

PLUGIN(.logs = logs, .log_count = 1)
