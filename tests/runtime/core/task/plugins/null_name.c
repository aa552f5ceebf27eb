#include "plugin_table.h"

static const taskc_reward_term terms[] = {{NULL, "", {0, 1}}};

PLUGIN(.terms = terms, .term_count = 1)
