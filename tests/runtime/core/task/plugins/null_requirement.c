#include "plugin_table.h"

static const taskc_requirement requirements[] = {{NULL, {0, 3}}};

PLUGIN(.requirements = requirements, .requirement_count = 1)
