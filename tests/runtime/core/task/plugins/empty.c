#include "plugin_table.h"

PLUGIN(.doc = "does nothing")
