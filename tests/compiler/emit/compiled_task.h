// Tasks that are really compiled, loaded and called.
#pragma once

#include <taskc/plugin.h>

#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tests/compiler/temporary_folder.h"

namespace compiler {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// A loaded plugin.
class CompiledTask {
 public:
  // Checks, emits, compiles and loads `text`. `optimization` takes the place of -O2.
  explicit CompiledTask(const std::string& text, const std::string& optimization = "-O2",
                        const std::string& path = "test.task");
  ~CompiledTask();
  CompiledTask(const CompiledTask&) = delete;
  CompiledTask& operator=(const CompiledTask&) = delete;

  const taskc_plugin& plugin() const { return *plugin_; }

 private:
  TemporaryFolder folder_;
  void* library_ = nullptr;
  const taskc_plugin* plugin_ = nullptr;
};

// One host of a plugin, as small as a host can be. It knows nothing but taskc/plugin.h: were it
// made of plugins/host, a mistake that the emitter and that library share could not be seen here.
class Instance {
 public:
  explicit Instance(const CompiledTask& task);

  // Values of a sensor, as doubles whatever its type. Unknown names and wrong counts throw.
  void Sense(const std::string& sensor, const std::vector<double>& values);
  void SetParam(const std::string& param, double value);
  // Of the goals of the episodes that start from now on.
  void SetSeed(taskc_uint64 seed) { frame_.seed = seed; }
  // Of the learner, for potentials.
  void SetDiscount(double discount) { frame_.discount = discount; }
  // How the episode has ended, for `end_of_episode`: TASKC_SUCCESS, TASKC_FAILURE, TASKC_TRUNCATED.
  void SetOutcome(taskc_int32 outcome) { frame_.outcome = outcome; }
  void Initialize() { plugin_.initialize(&frame_); }
  // Calls one event; an event that the task does not have does nothing.
  void Fire(int event, double time_step = 0);
  void Measure() { plugin_.measure(&frame_); }
  // All sums of terms are 0 again.
  void ClearTerms();

  double reward() const { return frame_.reward; }
  int end() const { return frame_.end; }
  int fault() const { return frame_.fault; }
  int violation() const { return frame_.violation; }
  double Term(const std::string& name) const;
  double Metric(const std::string& name) const;
  const taskc_log_state& Log(const std::string& name) const;
  double Memory(const std::string& name, size_t element = 0) const;
  double Goal(const std::string& name, size_t element = 0) const;
  const std::vector<unsigned char>& memory_bytes() const { return memory_; }

 private:
  const taskc_plugin& plugin_;
  std::vector<std::vector<unsigned char>> sensors_;
  std::vector<const void*> sensor_pointers_;
  std::vector<double> params_;
  std::vector<unsigned char> memory_;
  std::vector<double> terms_;
  std::vector<double> metrics_;
  std::vector<taskc_log_state> logs_;
  taskc_frame frame_{};
};

}  // namespace compiler
