#include "plugin_table.h"

PLUGIN(.memory_size = 24)
