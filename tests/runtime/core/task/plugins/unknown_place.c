#include "plugin_table.h"

static const taskc_reward_term terms[] = {{"fall", "", {1, 4}}};

PLUGIN(.terms = terms, .term_count = 1)
