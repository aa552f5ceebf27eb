#include "plugin_table.h"

static const taskc_end ends[] = {{"over", 3, {0, 12}}};

PLUGIN(.ends = ends, .end_count = 1)
