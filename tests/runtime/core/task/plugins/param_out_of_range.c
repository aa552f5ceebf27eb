#include "plugin_table.h"

static const taskc_param params[] = {{"gain", "", "", TASKC_REAL, 5, 0, 4}};

PLUGIN(.params = params, .param_count = 1)
