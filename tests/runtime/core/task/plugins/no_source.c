#include "plugin_table.h"

PLUGIN(.source_count = 0)
