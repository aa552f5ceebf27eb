#include "plugin_table.h"

static const taskc_param params[] = {
    {"gain", "", "", TASKC_REAL, __builtin_nan(""), -__builtin_inf(), __builtin_inf()}};

PLUGIN(.params = params, .param_count = 1)
