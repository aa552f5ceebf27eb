// Linked so that closing it does not unload it, as happens to C++ libraries with unique symbols.
#include "plugin_table.h"

PLUGIN(.name = "stays loaded")
