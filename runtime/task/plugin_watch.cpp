#include "runtime/task/plugin_watch.h"

namespace runtime {
namespace {

PluginWatch own_watch;
PluginWatch* the_watch = &own_watch;

}  // namespace

PluginWatch& ThePluginWatch() { return *the_watch; }

void SetPluginWatch(PluginWatch& watch) { the_watch = &watch; }

}  // namespace runtime
