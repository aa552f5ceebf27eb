#include "plugin_table.h"

PLUGIN(.sensor_count = 3)
