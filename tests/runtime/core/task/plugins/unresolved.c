#include "plugin_table.h"

void defined_nowhere(taskc_frame* frame);

PLUGIN(.events = {defined_nowhere})
