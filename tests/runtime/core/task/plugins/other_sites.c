// For a robot whose sites have other names than those of these tests.
#include "plugin_table.h"

static const taskc_part sites[] = {{"heel"}, {"toe"}};

PLUGIN(.sites = sites, .site_count = 2)
