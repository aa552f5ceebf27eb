#include "plugin_table.h"

static const taskc_requirement requirements[] = {{"it stands", {7, 3}}};

PLUGIN(.requirements = requirements, .requirement_count = 1)
