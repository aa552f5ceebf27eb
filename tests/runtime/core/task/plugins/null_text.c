#include "plugin_table.h"

PLUGIN(.source_hash = NULL)
