#include <stddef.h>
#include <taskc/plugin.h>

__attribute__((visibility("default"))) const taskc_plugin* taskc_plugin_get(void) { return NULL; }
