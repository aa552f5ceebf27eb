// What can be done to a graph while a robot learns with it, at a moment when nothing of it runs.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "runtime/core/module/context.h"
#include "runtime/core/module/module_graph.h"
#include "runtime/training/environment/environment.h"
#include "runtime/training/learning/learner.h"
#include "runtime/training/run/task_modules.h"

namespace runtime {

// Each function does all that its name says, or throws UserError and changes nothing.
class LiveGraph {
 public:
  // `graph`: started, with one environment and one learner; throws UserError where it has not.
  // All of these outlive this object.
  LiveGraph(ModuleGraph& graph, const ModuleTypes& types, const Context& context);

  ModuleGraph& graph() const { return graph_; }
  const Environment& environment() const { return environment_; }
  Learner& learner() const { return learner_; }
  UniversalTask& FindTask(std::string_view name) const;
  UniversalTask& active_task() const;

  void CheckLoad(const std::string& name, const Plugin& plugin) const;
  // A new task module that hears of everything the active task hears of, right after it. It sleeps
  // until the next episode starts.
  UniversalTask& Load(const std::string& name, std::unique_ptr<TaskInstance> instance);
  void Unload(const std::string& name);

  void CheckSwap(const std::string& name, const Plugin& plugin) const;
  void Swap(const std::string& name, std::unique_ptr<TaskInstance> instance);
  void Rollback(const std::string& name);

  // `now`: in the middle of an episode, of which the shadow must not have reached the end.
  void CheckPromote(const std::string& name, bool now) const;
  // The shadow's reward and ends go where those of the active task went.
  void Promote(const std::string& name);

  // `parameter`: "task.weight". Refuses parameters that have no effect after the start.
  void Set(const std::string& parameter, const ParameterValue& value);
  const Parameter& FindParameter(const std::string& parameter) const;
  ParameterValue Get(const std::string& parameter) const;

  // `goal`: "task.velocity". `value`: in SI units, as many numbers as the goal has elements.
  void CheckGoal(const std::string& goal) const;
  void HoldGoal(const std::string& goal, const std::vector<double>& value);
  void ReleaseGoal(const std::string& goal);

  // In the place of the out port that an in port has already. Neither a module that is not started
  // yet nor its slots can be used by others.
  void Connect(const std::string& first, const std::string& second);
  // Refuses to leave an in port without a value, or the learner without a task.
  void Disconnect(const std::string& first, const std::string& second);

  // What these parameters make of a new module: all that are not as they are by default. A file
  // that one of them names is read here, and not again where this is repeated.
  std::vector<std::pair<std::string, ParameterValue>> Resolved(
      const std::string& type, const std::string& name,
      const std::vector<std::pair<std::string, ParameterValue>>& parameters) const;
  // Starts it as soon as its in ports are connected. Task modules come by Load().
  void AddModule(const std::string& type, const std::string& name,
                 const std::vector<std::pair<std::string, ParameterValue>>& parameters);
  // Refuses what the run cannot do without.
  void RemoveModule(const std::string& name);
  // "" where it is started.
  std::string WhyNotStarted(const std::string& module) const;

 private:
  struct Goal {
    UniversalTask* task;
    size_t goal;
  };
  Goal FindGoal(const std::string& goal) const;
  void CheckIsUsable(const Port& port, const Port& by) const;
  // Whether a learner goes on seeing what it has learned from where `next`, of the task `name`,
  // takes the place of what `present` observes.
  static void CheckIsSeen(const UniversalTask& present, const ObservationLayout& next,
                          const std::string& name);
  // The same where an in port gets the out port `next` of a task for `present`, that of another.
  static void CheckIsSeenInstead(const Port& present, const Port& next);
  void CheckIsStillPaid(const Port& a, const Port& b) const;
  void CheckIsNeeded(const Module& module) const;
  void StartWhatCan();

  ModuleGraph& graph_;
  const ModuleTypes& types_;
  const Context& context_;
  const Environment& environment_;
  Learner& learner_;
  std::map<std::string, std::string> not_started_;  // modules, and why
};

}  // namespace runtime
