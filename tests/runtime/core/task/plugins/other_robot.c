#include "plugin_table.h"

PLUGIN(.robot = "snake")
