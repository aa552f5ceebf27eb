#include "plugin_table.h"

static const taskc_source no_text[] = {{"test.task", NULL}};

PLUGIN(.sources = no_text)
