#include "plugin_table.h"

static const taskc_reward_term terms[] = {{"fall", "", {0, 1}}, {"fall", "", {0, 2}}};

PLUGIN(.terms = terms, .term_count = 2)
