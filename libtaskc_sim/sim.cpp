// The functions of sim.h.
#include <taskc/sim.h>

#include <algorithm>
#include <cstring>

#include "libtaskc_sim/environments.h"
#include "libtaskc_sim/failure.h"
#include "libtaskc_sim/shared_files.h"
#include "plugins/host/plugin.h"

namespace {

using libtaskc_sim::Guarded;
using libtaskc_sim::RequirePointer;

taskc_sim_options Defaults() {
  taskc_sim_options options{};
  options.struct_size = sizeof options;
  options.agent = "ppo";
  options.discount = 0.99;
  options.count = 1;
  return options;
}

// What the caller has set, and for what it knows nothing of the defaults.
taskc_sim_options Complete(const taskc_sim_options& given) {
  taskc_sim_options options = Defaults();
  std::memcpy(&options, &given, std::min(given.struct_size, sizeof options));
  if (options.agent == nullptr) options.agent = "ppo";
  return options;
}

}  // namespace

const char* taskc_sim_error() { return libtaskc::KeptMessage(); }

taskc_uint32 taskc_sim_abi_version() { return TASKC_ABI_VERSION; }

void taskc_sim_defaults(taskc_sim_options* options, size_t size) {
  taskc_sim_options defaults = Defaults();
  defaults.struct_size = std::min(size, sizeof defaults);
  std::memcpy(options, &defaults, defaults.struct_size);
}

taskc_status taskc_sim_new(const taskc_sim_options* options, taskc_sim** sim) {
  return Guarded(TASKC_SIM_ERROR_SETUP, [&] {
    RequirePointer(options, "`options`");
    RequirePointer(sim, "`sim`");
    const taskc_sim_options complete = Complete(*options);
    RequirePointer(complete.plugin, "`plugin`");
    libtaskc_sim::FindSharedFiles();
    const host::Plugin checked(complete.plugin);  // says what is wrong with it by a code
    *sim = new taskc_sim(complete);
  });
}

void taskc_sim_delete(taskc_sim* sim) { delete sim; }

const taskc_sim_description* taskc_sim_describe(const taskc_sim* sim) {
  return &sim->description();
}

taskc_status taskc_sim_reset(taskc_sim* sim, const unsigned char* which, const taskc_uint64* seeds,
                             float* observations) {
  return Guarded(TASKC_SIM_ERROR_EPISODE, [&] {
    RequirePointer(sim, "`sim`");
    sim->Reset(which, seeds, observations);
  });
}

taskc_status taskc_sim_step(taskc_sim* sim, const float* actions, const taskc_sim_arrays* arrays) {
  return Guarded(TASKC_SIM_ERROR_EPISODE, [&] {
    RequirePointer(sim, "`sim`");
    RequirePointer(actions, "`actions`");
    RequirePointer(arrays, "`arrays`");
    sim->Step(actions, *arrays);
  });
}

taskc_status taskc_sim_set(taskc_sim* sim, const unsigned char* which, const char* parameter,
                           const char* value) {
  return Guarded(TASKC_SIM_ERROR_SETUP, [&] {
    RequirePointer(sim, "`sim`");
    RequirePointer(parameter, "`parameter`");
    RequirePointer(value, "`value`");
    sim->Set(which, parameter, value);
  });
}

taskc_status taskc_sim_last_episode(const taskc_sim* sim, taskc_uint32 environment,
                                    taskc_sim_episode* episode) {
  return Guarded(TASKC_SIM_ERROR_EPISODE, [&] {
    RequirePointer(sim, "`sim`");
    RequirePointer(episode, "`episode`");
    *episode = sim->LastEpisode(environment);
  });
}

taskc_status taskc_sim_last_ends(const taskc_sim* sim, const taskc_sim_ends* ends) {
  return Guarded(TASKC_SIM_ERROR_EPISODE, [&] {
    RequirePointer(sim, "`sim`");
    RequirePointer(ends, "`ends`");
    sim->LastEnds(*ends);
  });
}

taskc_status taskc_sim_render(taskc_sim* sim, taskc_uint32 environment, taskc_uint32 size,
                              unsigned char* rgb) {
  return Guarded(TASKC_SIM_ERROR_SETUP, [&] {
    RequirePointer(sim, "`sim`");
    RequirePointer(rgb, "`rgb`");
    sim->Render(environment, size, rgb);
  });
}
