#include "plugin_table.h"

static const taskc_reward_term terms[] = {{"fall", "", 1}, {"fall", "", 2}};

PLUGIN(.terms = terms, .term_count = 2)
