#include "plugin_table.h"

static const taskc_param params[] = {{"count", "", "", TASKC_INT, 2.5, 0, 4}};

PLUGIN(.params = params, .param_count = 1)
