// What the library says of episodes that are over.
#pragma once

#include <taskc/sim.h>

#include <cstddef>

#include "libtaskc_sim/robot_in_task.h"

namespace libtaskc_sim {

// The one that has ended last. Precondition: one has. Points into `robot`.
taskc_sim_episode EpisodeOf(const RobotInTask& robot);

// The columns of a `taskc_sim_ends`, for so many environments.
class EndColumns {
 public:
  EndColumns(const taskc_sim_ends& ends, const taskc_plugin& task, size_t count)
      : ends_(ends), task_(task), count_(count) {}

  void Write(size_t environment, const taskc_sim_episode& episode) const;
  // Where none has ended.
  void Clear(size_t environment) const;

 private:
  // `values`: one for each column of `columns`; null: 0 in all of them.
  void WriteTo(double* columns, size_t environment, const double* values, size_t size) const;

  const taskc_sim_ends& ends_;
  const taskc_plugin& task_;
  const size_t count_;
};

}  // namespace libtaskc_sim
