// The one module that runs any compiled task.
#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/core/module/context.h"
#include "runtime/core/module/module.h"
#include "runtime/core/module/module_graph.h"
#include "runtime/core/module/observations.h"
#include "runtime/core/module/sensor_data.h"
#include "runtime/core/module/values.h"
#include "runtime/core/task/plugin.h"
#include "runtime/core/task/task_instance.h"

namespace runtime {

// How a task says that an episode ended.
struct TaskEnd {
  EndKind kind = EndKind::kTruncated;
  std::string reason;
};

// At first an instance of the task in Context::task; any number of them can run side by side, and
// each can get another task while it runs.
//
//   in       one port for each sensor that the task reads, of the sensor's name
//   slots    the events; each returns at once where the task has nothing to do
//   signals  reward: what an event pays, also 0, after every event with an own function;
//            end_of_episode: after that, the first end that is reached in an episode
//   out      observations: what the task lets a learner see, computed when it is asked for
//
// A sensor that the task declares itself is a parameter, too: where that is set, it is what the
// task reads, and the in port has no connection. `--set` comes before the connections of an agent;
// after the start, the last word holds, be it a value or a connection.
//
// An event brings exactly those sensors up to date that it reads. Ends that are reached later in
// the episode, or in the event at its end, are not emitted. A requirement that does not hold ends
// the episode like a limit, with the reason "requirement: ..."; it comes before an end that the
// same event reached. The task's params are this module's parameters.
class UniversalTask : public Module, public TaskObservations {
 public:
  static constexpr const char* kRole = "task module";  // for ModuleGraph::FindOnly()

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
  Out<TaskObservations> observations{this, "observations", this};

  // Throws UserError if the plugin does not fit Context::robot, or if there is none.
  UniversalTask(const std::string& name, const Context& context);
  // `seed`: of the run, for the goals that the task draws.
  UniversalTask(std::string name, const robot::RobotDescription& robot,
                std::unique_ptr<TaskInstance> instance, uint64_t seed = 0);

  // Throws UserError if a sensor's in port has no connection, and it is not told.
  void Start() override;
  void Set(std::string_view parameter, const ParameterValue& value) override;
  // The values of the params and of the variables that live as long as the run, also those of the
  // previous task.
  void Save(std::ostream& stream) const override;
  void Load(std::istream& stream) override;

  ObservationLayout observation_layout() const override { return ObservationLayoutOf(plugin()); }
  std::span<const double> Observe() const override;

  // Connects the sensors that are not connected yet, nor told, to the out ports of their name.
  // Precondition: there are such ports.
  void ConnectSensors(const ModuleGraph& graph);
  // To be called after a port of this module was connected.
  void NoteConnection();
  // Throws UserError if the task does not fit the robot, or if it reads a sensor that no module of
  // `graph` offers and nobody has told `active`.
  static void CheckCanLoad(const Plugin& plugin, const UniversalTask& active,
                           const ModuleGraph& graph);
  // Throws UserError if the task does not fit the robot, or if it reads a sensor that this module
  // has not, or not connected, nor told, and that no module of `graph` offers.
  void CheckCanSwap(const Plugin& plugin, const ModuleGraph& graph) const;
  // Another task from now on, which takes over what it can (TaskInstance::TakeOver). The sensors
  // that are new in it are connected to the out ports of their name. What was until now is kept as
  // the previous task. Not from inside an event. Throws as CheckCanSwap(), and changes nothing
  // then.
  void Swap(std::unique_ptr<TaskInstance> next, const ModuleGraph& graph);
  // The previous task again; the present one becomes the previous. Throws UserError if there is
  // none.
  void Rollback(const ModuleGraph& graph);
  // As if this module had run the episodes that `other`, which has the same task, has run.
  void TakeOverRun(const UniversalTask& other) { instance_->TakeOverRun(*other.instance_); }
  // Null before the first swap.
  const TaskInstance* previous() const { return previous_.get(); }
  // Throws UserError before the first swap.
  const TaskInstance& FindPrevious() const;

  // The number in the run of the episode that starts next; else it is one more than the last.
  void SetNextEpisode(int64_t number) { episode_ = number - 1; }
  // How the episode that starts next begins, as the task draws it; nothing where it says nothing.
  // Right before that episode. `attempt`: how many were drawn for it before, of which each is
  // another one. Throws as runtime::DrawStart().
  std::optional<robot::StartState> DrawStart(uint32_t attempt = 0) {
    return instance_->DrawStart(robot_, seed_, episode_ + 1, attempt);
  }
  // Its number among the task's goals. Throws UserError where there is no goal of this name.
  size_t FindGoal(std::string_view goal) const;
  // From now on the goal has this value, in SI units, and the task does not draw it. Throws
  // UserError where it has another number of elements.
  void HoldGoal(size_t goal, std::span<const double> value);
  void ReleaseGoal(size_t goal) { instance_->ReleaseGoal(goal); }

  // What potentials are discounted by: the learner's, which may change between two time steps and
  // lives as long as this module. At first 1.
  void FollowDiscount(const double& discount) { discount_ = &discount; }

  // A shadow is evaluated like the task that the learner is paid by, but nobody ends an episode for
  // it: after its own first end it ends the episode for itself, `at_once` or with the action, and
  // then sleeps until the next episode starts.
  enum class Role { kActive, kShadowEndsWithAction, kShadowEndsAtOnce };
  void SetRole(Role role) { role_ = role; }
  bool is_shadow() const { return role_ != Role::kActive; }
  // Whether an end that the task reaches from now on would be this episode's.
  bool can_end() const { return !is_asleep_ && !episode_is_over_ && !end_was_reached_; }

  const TaskInstance& instance() const { return *instance_; }
  const taskc_plugin& plugin() const { return instance_->table(); }

  // Of the current episode: all that was paid after the event at its start, what each reward term
  // has paid, where it could not be paid, and which requirements did not hold.
  double episode_return() const { return return_; }
  std::span<const double> term_sums() const { return instance_->term_sums(); }
  std::span<const Incidents> faults() const { return instance_->faults(); }
  std::span<const Incidents> violations() const { return instance_->violations(); }
  // All that was not paid: those of the terms, and sums of an event's terms that were not finite or
  // too large (taskc/largest_reward.h). So the return is finite.
  int64_t fault_count() const { return instance_->fault_count(); }
  // What a learner did not see as it was, since it was not finite.
  std::span<const Incidents> observation_faults() const { return instance_->observation_faults(); }
  // Whether an episode has ended for this task since its last start.
  bool has_ended() const { return episode_is_over_; }
  // Of the episode that has ended: the first end that the task reached, or else the one that it was
  // told of; one value for each metric, and one for each log.
  const TaskEnd& end() const { return end_; }
  std::span<const double> metrics() const { return instance_->metrics(); }
  // What each metric is at the end of the last time step, before it is reduced over the episode.
  // Not from inside an event, and not before the first time step.
  std::span<const double> MeasureNow();
  std::span<const double> logs() const { return instance_->logs(); }

 private:
  static constexpr double kNoDiscount = 1;

  struct SensorRead {
    const SensorIn* port;
    const void** data;  // the sensor's entry in the frame
  };
  using Outcome = TaskInstance::Outcome;

  void StartEpisode();
  void EndEpisode(EpisodeEnd end);
  void StartAction() { Handle(TASKC_START_OF_ACTION, 0); }
  void EndAction();
  void StartTimeStep(double time_step) { Handle(TASKC_START_OF_TIME_STEP, time_step); }
  void EndTimeStep(double time_step);
  void StartPhysicsStep(double time_step) { Handle(TASKC_START_OF_PHYSICS_STEP, time_step); }
  void EndPhysicsStep(double time_step) { Handle(TASKC_END_OF_PHYSICS_STEP, time_step); }

  void Handle(int event, double time_step);
  std::optional<Outcome> Call(int event, double time_step);
  void Emit(const std::optional<Outcome>& outcome);
  void NoteEnd(const EpisodeEnd& end);
  // Ends the episode of a shadow that has reached an end.
  void EndOwnEpisode();
  // Brings those sensors up to date that event number `reader`, TASKC_MEASURE or TASKC_OBSERVE
  // reads.
  void Sense(int reader) const;

  using Sensors = std::vector<std::unique_ptr<SensorIn>>;

  ToldSensors& told() { return instance_->told(); }
  const ToldSensors& told() const { return std::as_const(*instance_).told(); }

  Sensors::const_iterator FindSensor(const taskc_sensor& sensor) const;
  // What is told is not read from a port.
  void DisconnectTold();
  // Puts `next` in the place of the present task, which is returned. The ports of sensors that only
  // one of the two reads go or come, unconnected.
  std::unique_ptr<TaskInstance> Exchange(std::unique_ptr<TaskInstance> next);
  void BindSensors();

  const robot::RobotDescription& robot_;
  uint64_t seed_;
  const double* discount_ = &kNoDiscount;
  int64_t episode_ = 0;  // the number of the current one
  std::unique_ptr<TaskInstance> instance_;
  std::unique_ptr<TaskInstance> previous_;
  Sensors sensors_;  // in the order of the task
  // What each event, and the evaluation of metrics and observations, has to bring up to date.
  std::array<std::vector<SensorRead>, TASKC_READER_COUNT> reads_;

  Role role_ = Role::kActive;
  double return_ = 0;
  TaskEnd end_;
  bool is_asleep_ = true;  // no events until the next episode starts
  bool episode_is_over_ = false;
  bool end_was_reached_ = false;
};

}  // namespace runtime
