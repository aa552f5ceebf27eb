// The memory that a host gives to a compiled task.
#pragma once

#include <taskc/plugin.h>

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

class PluginHost {
 public:
  // `sensors`: where each of the plugin's sensors is, in its order.
  PluginHost(const taskc_plugin& plugin, std::vector<const void*> sensors)
      : sensors_(std::move(sensors)),
        memory_(plugin.memory_size / sizeof(std::max_align_t) + 1),
        terms_(plugin.term_count),
        metrics_(plugin.metric_count),
        logs_(plugin.log_count) {
    for (const taskc_param& param : std::span(plugin.params, plugin.param_count)) {
      params_.push_back(param.initial);
    }
    frame_.sensors = sensors_.data();
    frame_.params = params_.data();
    frame_.memory = memory_.data();
    frame_.terms = terms_.data();
    frame_.metrics = metrics_.data();
    frame_.logs = logs_.data();
    plugin.initialize(&frame_);
  }
  PluginHost(const PluginHost&) = delete;
  PluginHost& operator=(const PluginHost&) = delete;

  // As before each call of a callback.
  taskc_frame* NextFrame(double time_step) {
    frame_.time_step = time_step;
    frame_.reward = 0;
    frame_.end = -1;
    frame_.fault = -1;
    frame_.violation = -1;
    return &frame_;
  }

 private:
  std::vector<const void*> sensors_;
  std::vector<double> params_;
  std::vector<std::max_align_t> memory_;
  std::vector<double> terms_;
  std::vector<double> metrics_;
  std::vector<taskc_log_state> logs_;
  taskc_frame frame_{};
};
