// The one module that runs any compiled task.
#pragma once

#include <taskc/plugin.h>

#include <array>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/module/context.h"
#include "runtime/module/module.h"
#include "runtime/module/sensor_data.h"
#include "runtime/module/values.h"
#include "runtime/task/metric_reducer.h"
#include "runtime/task/plugin.h"
#include "runtime/task/task_memory.h"

namespace runtime {

// How often something went wrong in an episode, and when it did for the first time.
struct Incidents {
  int64_t count = 0;
  double first_time = 0;  // [s] since the start of the episode
};

// An instance of the task in Context::task_plugin. Any number of them can run side by side.
//
//   in       one port for each sensor that the task reads, of the sensor's name
//   slots    the events; each returns at once where the task has nothing to do
//   signals  reward: what an event pays, also 0, after every event with an own function;
//            end_of_episode: after that, the first end that is reached in an episode
//
// An event brings exactly those sensors up to date that it reads. Ends that are reached later in
// the episode, or in the event at its end, are not emitted. A requirement that does not hold ends
// the episode like a limit, with the reason "requirement: ..."; it comes before an end that the
// same event reached. The task's params are this module's parameters.
class UniversalTask : public Module {
 public:
  Slot<> on_start_of_episode{this, "on_start_of_episode", Bind<&UniversalTask::StartEpisode>{}};
  Slot<EpisodeEnd> on_end_of_episode{this, "on_end_of_episode", Bind<&UniversalTask::EndEpisode>{}};
  Slot<> on_start_of_action{this, "on_start_of_action", Bind<&UniversalTask::StartAction>{}};
  Slot<> on_end_of_action{this, "on_end_of_action", Bind<&UniversalTask::EndAction>{}};
  Slot<double> on_start_of_time_step{this, "on_start_of_time_step",
                                     Bind<&UniversalTask::StartTimeStep>{}};
  Slot<double> on_end_of_time_step{this, "on_end_of_time_step",
                                   Bind<&UniversalTask::EndTimeStep>{}};
  Slot<double> on_start_of_physics_step{this, "on_start_of_physics_step",
                                        Bind<&UniversalTask::StartPhysicsStep>{}};
  Slot<double> on_end_of_physics_step{this, "on_end_of_physics_step",
                                      Bind<&UniversalTask::EndPhysicsStep>{}};
  Signal<double> reward{this, "reward"};
  Signal<EpisodeEnd> end_of_episode{this, "end_of_episode"};

  // Throws UserError if the plugin cannot be loaded or does not fit Context::robot.
  UniversalTask(std::string name, const Context& context);

  // Throws UserError if a sensor's in port has no connection.
  void Start() override;
  void Set(std::string_view parameter, const ParameterValue& value) override;
  // The values of the params and of the variables that live as long as the run.
  void Save(std::ostream& stream) const override;
  void Load(std::istream& stream) override;

  const taskc_plugin& plugin() const { return plugin_.table(); }

  // Of the current episode: what each reward term has paid, where it could not be paid, and which
  // requirements did not hold.
  std::span<const double> term_sums() const { return term_sums_; }
  std::span<const Incidents> faults() const { return faults_; }
  std::span<const Incidents> violations() const { return violations_; }
  // All that was not paid: those of the terms, and sums of finite terms that were not finite.
  int64_t fault_count() const { return fault_count_; }
  // Of the episode that has ended: one value for each metric, and one for each log.
  std::span<const double> metrics() const { return reducer_.values(); }
  std::span<const double> logs() const { return logged_; }

 private:
  // A param's value, in the one of these that belongs to its type.
  struct Param {
    bool flag = false;
    int64_t integer = 0;
    double real = 0;
  };

  struct SensorRead {
    const SensorIn* port;
    const void** data;  // the sensor's entry in the frame
  };

  // What one event function did.
  struct Outcome {
    double reward = 0;
    std::optional<EpisodeEnd> end;
  };

  void AddParams();
  void AddSensors();
  void BindFrame();
  void ResetEpisode();

  void StartEpisode();
  void EndEpisode(EpisodeEnd);
  void StartAction() { Handle(TASKC_START_OF_ACTION, 0); }
  void EndAction() { Handle(TASKC_END_OF_ACTION, 0); }
  void StartTimeStep(double time_step) { Handle(TASKC_START_OF_TIME_STEP, time_step); }
  void EndTimeStep(double time_step);
  void StartPhysicsStep(double time_step) { Handle(TASKC_START_OF_PHYSICS_STEP, time_step); }
  void EndPhysicsStep(double time_step) { Handle(TASKC_END_OF_PHYSICS_STEP, time_step); }

  void Handle(int event, double time_step);
  std::optional<Outcome> Call(int event, double time_step);
  void Emit(const std::optional<Outcome>& outcome);
  // Brings those sensors up to date that event number `reader`, or TASKC_MEASURE, reads.
  void Sense(int reader);
  void Measure();
  // How the last event function ended the episode, if it did.
  std::optional<EpisodeEnd> EndReached() const;
  void CountFault();
  void CountViolation();
  void ReduceLogs();

  Plugin plugin_;
  TaskMemory memory_;
  std::vector<Param> params_;

  // What the frame points to.
  std::vector<std::unique_ptr<SensorIn>> sensors_;
  std::vector<const void*> sensor_data_;
  std::vector<double> param_values_;
  std::vector<double> term_sums_;
  std::vector<double> measured_;
  std::vector<taskc_log_state> log_states_;
  taskc_frame frame_{};

  // What each event, and the evaluation of the metrics, has to bring up to date.
  std::array<std::vector<SensorRead>, TASKC_MEASURE + 1> reads_;

  MetricReducer reducer_;
  std::vector<double> logged_;
  std::vector<Incidents> faults_;
  int64_t fault_count_ = 0;
  std::vector<Incidents> violations_;
  std::vector<std::string> violation_reasons_;  // one for each requirement
  double time_ = 0;  // [s] since the start of the episode, at the end of the last time step
  bool episode_is_over_ = false;
  bool end_was_emitted_ = false;
};

}  // namespace runtime
