#include "plugin_table.h"

static const taskc_metric metrics[] = {{"height", "", "m", TASKC_LAST}};

PLUGIN(.metrics = metrics, .metric_count = 4000000000u)
