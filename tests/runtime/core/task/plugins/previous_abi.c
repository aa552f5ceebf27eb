// What a plugin of ABI 4 begins with, and how large its table was.
#include <taskc/plugin.h>

static const struct {
  taskc_uint32 abi_version;
  taskc_uint32 struct_size;
  unsigned char rest[352];
} plugin = {.abi_version = 4, .struct_size = 360};

__attribute__((visibility("default"))) const taskc_plugin* taskc_plugin_get(void) {
  return (const taskc_plugin*)(const void*)&plugin;
}
