// What the handles of host.h stand for.
#pragma once

#include <taskc/host.h>

#include <memory>

#include "libtaskc/episode.h"
#include "libtaskc/sensor_sources.h"
#include "plugins/host/plugin.h"

struct taskc_task {
  std::shared_ptr<const host::Plugin> plugin;
};

struct taskc_instance {
  explicit taskc_instance(std::shared_ptr<const host::Plugin> loaded)
      : plugin(std::move(loaded)), episode(plugin->table()), sensors(episode.frame()) {}

  const taskc_plugin& task() const { return plugin->table(); }
  host::TaskFrame& frame() { return episode.frame(); }
  const host::TaskFrame& frame() const { return episode.frame(); }

  std::shared_ptr<const host::Plugin> plugin;  // stays loaded until all else is gone
  libtaskc::Episode episode;
  libtaskc::SensorSources sensors;
};
