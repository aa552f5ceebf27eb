// One running instance of a plugin.
#pragma once

#include <taskc/plugin.h>

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plugins/host/task_episode.h"
#include "runtime/core/module/module.h"
#include "runtime/core/module/observations.h"
#include "runtime/core/module/values.h"
#include "runtime/core/task/fault_state.h"
#include "runtime/core/task/plugin.h"
#include "runtime/core/task/plugin_watch.h"
#include "runtime/core/task/task_goals.h"
#include "runtime/core/task/task_memory.h"
#include "runtime/core/task/task_phases.h"
#include "runtime/core/task/task_start.h"
#include "runtime/core/task/told_sensors.h"

namespace runtime {

// How often something went wrong in an episode, and when it did for the first time.
struct Incidents {
  int64_t count = 0;
  double first_time = 0;  // [s] since the start of the episode
};

// What the task lets a learner see.
ObservationLayout ObservationLayoutOf(const taskc_plugin& table);

// A plugin's memory, its params, and what it has paid and measured in the current episode. It knows
// no ports: whoever owns it keeps the sensors' data up to date.
class TaskInstance {
 public:
  // What one event function did.
  struct Outcome {
    double reward = 0;
    std::optional<EpisodeEnd> end;
  };

  // `id`: how the plugin is known to the run's record and to a guarding process; from 1.
  explicit TaskInstance(std::shared_ptr<const Plugin> plugin, int64_t id = 1);
  TaskInstance(const TaskInstance&) = delete;
  TaskInstance& operator=(const TaskInstance&) = delete;

  const std::shared_ptr<const Plugin>& plugin() const { return plugin_; }
  const taskc_plugin& table() const { return plugin_->table(); }
  int64_t id() const { return id_; }

  // The params, and what the task's own sensors are told, as parameters of a module, whose targets
  // live in this object.
  std::vector<Parameter> Params();
  // To be called after such a target was changed.
  void PassParams();

  // Where the event functions look for the data of sensor number `index`.
  const void** sensor_data(size_t index) { return &host_.sensor(index); }

  // What a user has told the task's own sensors.
  ToldSensors& told() { return told_; }
  const ToldSensors& told() const { return told_; }

  // `episode`: its number in the run; with the run's seed it decides what goals are drawn.
  void StartEpisode(uint64_t run_seed, int64_t episode);
  // How the episode begins that is the next to start; see task_start.h.
  std::optional<robot::StartState> DrawStart(const robot::RobotDescription& robot,
                                             uint64_t run_seed, int64_t episode, uint32_t attempt);
  // The learner's, for one action; at first 1.
  void SetDiscount(double discount) { host_.SetDiscount(discount); }
  // How the episode has ended for the learner; before the event at its end.
  void SetOutcome(EndKind kind);
  // Calls the function of an event, if the task has one.
  std::optional<Outcome> Call(int event, double time_step);
  // To be called at the end of each time step, before all else.
  void AdvanceTime(double time_step) {
    time_ += time_step;
    episode_.NoteTimeStep(time_step);
    phases_.AddTime(time_step);
  }
  // To be called at the end of each time step in which needs_measuring(), and of the episode.
  bool needs_measuring() const { return episode_.needs_measuring(); }
  void EndTimeStep();
  void EndEpisode();
  // Brings measured() up to date between two time steps.
  void Measure();
  // What each metric was when it was measured last.
  std::span<const double> measured() const { return host_.metrics(); }

  // What the learner sees now. A number that is not finite is 0 in it, and counted.
  std::span<const double> Observe();

  const TaskGoals& goals() const { return goals_; }
  // From now on the goal has this value, and the task does not draw it; see TaskGoals::Hold().
  void HoldGoal(size_t goal, std::span<const double> value) { goals_.Hold(goal, value, time_); }
  void ReleaseGoal(size_t goal) { goals_.Release(goal); }

  const TaskPhases& phases() const { return phases_; }

  // What it works on, to look at between two events.
  const host::TaskFrame& frame() const { return host_; }

  // Whether an episode can depend on those before it.
  bool remembers_episodes() const { return memory_.outlives_episodes(); }

  std::span<const double> term_sums() const { return host_.terms(); }
  std::span<const Incidents> faults() const { return faults_; }
  int64_t fault_count() const { return fault_count_; }
  // Of the episode's first fault of a term.
  const FaultState& fault_state() const { return fault_state_; }
  std::span<const Incidents> violations() const { return violations_; }
  std::span<const Incidents> observation_faults() const { return observation_faults_; }
  std::span<const double> metrics() const { return episode_.metrics(); }
  std::span<const double> logs() const { return episode_.logs(); }

  // Goes on where `old` is, as far as the two have variables of the same name, type and unit: the
  // params that differ from their initial value there and what sensors were told, where they lie in
  // the range here, and the memory of the run. `in_episode`: also all other memory, and what was
  // paid, measured and logged in the current episode.
  void TakeOver(const TaskInstance& old, bool in_episode);

  // As if this instance had run the episodes that `other`, of the same plugin, has run.
  void TakeOverRun(const TaskInstance& other) { memory_.TakeOver(other.memory_, false); }

  // The values of the params and of the variables that live as long as the run, and what sensors
  // are told.
  void Save(std::ostream& stream) const;
  // Throws UserError if the stream ends early.
  void Load(std::istream& stream);

 private:
  // A param's value, in the one of these that belongs to its type.
  struct Param {
    bool flag = false;
    int64_t integer = 0;
    double real = 0;
  };

  void SetParam(size_t index, double value);
  void TakeOverParams(const TaskInstance& old);
  void TakeOverSums(const TaskInstance& old);
  void Enter(taskc_event_function function);
  // Precondition: the task has a function for the event.
  host::EventOutcome Enter(int event, double time_step);
  // How an event has ended the episode, if it did.
  std::optional<EpisodeEnd> EndReached(const host::EventOutcome& outcome) const;
  void Count(int event, double time_step, const host::EventOutcome& outcome);

  std::shared_ptr<const Plugin> plugin_;
  int64_t id_;
  host::TaskEpisode episode_;
  host::TaskFrame& host_;  // that of the episode
  TaskMemory memory_;
  TaskGoals goals_;
  TaskPhases phases_;
  ToldSensors told_;
  std::vector<Param> params_;

  std::vector<Incidents> faults_;
  int64_t fault_count_ = 0;
  FaultState fault_state_;
  std::vector<Incidents> violations_;
  std::vector<Incidents> observation_faults_;
  std::vector<std::string> violation_reasons_;  // one for each requirement
  double time_ = 0;  // [s] since the start of the episode, at the end of the last time step
};

}  // namespace runtime
