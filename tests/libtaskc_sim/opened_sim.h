// Environments that end with the test, and the arrays that they fill.
#pragma once

#include <gtest/gtest.h>
#include <taskc/sim.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace libtaskc_sim {

inline taskc_sim_options OptionsOf(const char* plugin, taskc_uint32 count = 1) {
  taskc_sim_options options;
  taskc_sim_defaults(&options, sizeof options);
  options.plugin = plugin;
  options.profile = "fast-tree";
  options.count = count;
  return options;
}

// The element `i` of the decision `step` of the environment `environment`: no two are alike, and
// all are single precision numbers.
inline float ActionElement(int64_t environment, int64_t step, int64_t i) {
  return static_cast<float>(0.4 *
                            std::sin(static_cast<double>(3 * environment + 5 * step + 7 * i) / 3));
}

class OpenedSim {
 public:
  explicit OpenedSim(const taskc_sim_options& options) {
    EXPECT_EQ(taskc_sim_new(&options, &sim_), TASKC_OK) << taskc_sim_error();
    if (sim_ == nullptr) return;
    const taskc_sim_description& about = description();
    actions.resize(size_t{about.count} * about.action_size);
    observations.resize(size_t{about.count} * about.observation_size);
    last_observations.resize(observations.size());
    rewards.resize(about.count);
    terminated.resize(about.count);
    truncated.resize(about.count);
    term_sums.resize(size_t{about.count} * about.task->term_count);
  }
  ~OpenedSim() { taskc_sim_delete(sim_); }
  OpenedSim(const OpenedSim&) = delete;
  OpenedSim& operator=(const OpenedSim&) = delete;

  taskc_sim* get() const { return sim_; }
  const taskc_sim_description& description() const { return *taskc_sim_describe(sim_); }

  void Reset(const std::vector<taskc_uint64>& seeds) {
    EXPECT_EQ(
        taskc_sim_reset(sim_, nullptr, seeds.empty() ? nullptr : seeds.data(), observations.data()),
        TASKC_OK)
        << taskc_sim_error();
    step_ = 0;
  }
  taskc_status TryStep() {
    const taskc_sim_arrays arrays = {
        observations.data(), last_observations.data(), rewards.data(), terminated.data(),
        truncated.data(),    term_sums.data(),         &ended};
    return taskc_sim_step(sim_, actions.data(), &arrays);
  }
  // The decision that ActionElement() says.
  void Step() {
    const taskc_sim_description& about = description();
    for (size_t i = 0; i < actions.size(); ++i) {
      actions[i] = ActionElement(static_cast<int64_t>(i / about.action_size), step_,
                                 static_cast<int64_t>(i % about.action_size));
    }
    ++step_;
    EXPECT_EQ(TryStep(), TASKC_OK) << taskc_sim_error();
  }
  taskc_sim_episode LastEpisode(taskc_uint32 environment = 0) const {
    taskc_sim_episode episode{};
    EXPECT_EQ(taskc_sim_last_episode(sim_, environment, &episode), TASKC_OK) << taskc_sim_error();
    return episode;
  }

  std::vector<float> actions;
  std::vector<float> observations;
  std::vector<float> last_observations;
  std::vector<double> rewards;
  std::vector<unsigned char> terminated;
  std::vector<unsigned char> truncated;
  std::vector<double> term_sums;
  taskc_uint32 ended = 0;

 private:
  taskc_sim* sim_ = nullptr;
  int64_t step_ = 0;
};

}  // namespace libtaskc_sim
