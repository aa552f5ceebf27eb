// What a `taskc_sim` is.
#pragma once

#include <taskc/sim.h>

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "libtaskc_sim/description.h"
#include "libtaskc_sim/pictures.h"
#include "libtaskc_sim/robot_in_task.h"
#include "libtaskc_sim/worker_threads.h"
#include "runtime/trainer/setup/task_setup.h"

// All functions throw Failure, or what the runtime throws.
struct taskc_sim {
 public:
  explicit taskc_sim(const taskc_sim_options& options);

  const taskc_sim_description& description() const { return description_.shown(); }
  void Reset(const unsigned char* which, const taskc_uint64* seeds, float* observations);
  void Step(const float* actions, const taskc_sim_arrays& arrays);
  void Set(const unsigned char* which, const std::string& parameter, const std::string& value);
  taskc_sim_episode LastEpisode(taskc_uint32 environment) const;
  void LastEnds(const taskc_sim_ends& ends) const;
  void Render(taskc_uint32 environment, taskc_uint32 size, unsigned char* rgb);

 private:
  void CheckActions(const float* actions) const;
  void CheckIsReset() const;
  libtaskc_sim::Results ResultsOf(size_t environment, const taskc_sim_arrays& arrays) const;
  // Throws what the first of the environments has thrown.
  void ThrowFailure();
  const libtaskc_sim::RobotInTask& Robot(taskc_uint32 environment) const;

  const libtaskc_sim::Common common_;
  const runtime::TaskSetup setup_;
  std::deque<libtaskc_sim::RobotInTask> robots_;
  libtaskc_sim::WorkerThreads threads_;
  const libtaskc_sim::Description description_;
  libtaskc_sim::Pictures pictures_;
};
