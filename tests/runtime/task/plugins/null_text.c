#include "plugin_table.h"

PLUGIN(.source = NULL)
