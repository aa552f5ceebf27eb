#include "plugin_table.h"

PLUGIN(.abi_version = TASKC_ABI_VERSION + 1)
