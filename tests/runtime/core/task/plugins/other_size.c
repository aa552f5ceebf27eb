#include "plugin_table.h"

PLUGIN(.struct_size = sizeof(taskc_plugin) - 8)
