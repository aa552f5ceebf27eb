#include "runtime/live/control/live_graph.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/base/suggestion.h"
#include "runtime/core/module/connections.h"
#include "runtime/core/module/live_parameter.h"
#include "runtime/core/task/robot_check.h"

namespace runtime {
namespace {

// Connects each slot of `shadow` to what the same slot of `active` is connected to.
void ListenLike(const UniversalTask& active, const UniversalTask& shadow) {
  for (const Port* slot : active.ports()) {
    if (slot->kind() != PortKind::kSlot) continue;
    for (Port* signal : slot->Connections()) {
      Port::ConnectBehind(*signal, shadow.FindPort(slot->name()), *slot);
    }
  }
}

void MoveConnections(Port& from, Port& to) {
  for (Port* slot : from.Connections()) {
    Port::Disconnect(from, *slot);
    if (!to.IsConnectedTo(*slot)) Port::Connect(to, *slot);
  }
}

}  // namespace

LiveGraph::LiveGraph(ModuleGraph& graph, const ModuleTypes& types, const Context& context)
    : graph_(graph),
      types_(types),
      context_(context),
      environment_(graph.FindOnly<Environment>()),
      learner_(graph.FindOnly<Learner>()) {}

UniversalTask& LiveGraph::FindTask(std::string_view name) const {
  std::vector<std::string> names;
  for (UniversalTask* task : graph_.FindAll<UniversalTask>()) {
    if (task->name() == name) return *task;
    names.push_back(task->name());
  }
  throw UserError(fmt::format("there is no task module `{}`{}", name, Suggestion(name, names)));
}

UniversalTask& LiveGraph::active_task() const { return *FindTaskModules(graph_, learner_).active; }

void LiveGraph::CheckLoad(const std::string& name, const Plugin& plugin) const {
  graph_.CheckNewName(name);
  UniversalTask::CheckCanLoad(plugin, active_task(), graph_);
  CheckFitsWorld(plugin, *context_.task);
}

UniversalTask& LiveGraph::Load(const std::string& name, std::unique_ptr<TaskInstance> instance) {
  CheckLoad(name, *instance->plugin());
  const UniversalTask& active = active_task();
  instance->told().TakeOver(active.instance().told());  // it sees the same
  auto made =
      std::make_unique<UniversalTask>(name, *context_.robot, std::move(instance), context_.seed);
  UniversalTask& shadow = *made;
  graph_.Add(std::move(made));
  shadow.ConnectSensors(graph_);
  ListenLike(active, shadow);
  return shadow;
}

void LiveGraph::Unload(const std::string& name) {
  if (&FindTask(name) == &active_task()) {
    throw UserError(
        fmt::format("`{}` is the active task: promote another one first, or swap it", name));
  }
  graph_.Remove(name);
}

void LiveGraph::CheckIsSeen(const UniversalTask& present, const ObservationLayout& next,
                            const std::string& name) {
  if (present.observations.Connections().empty()) return;
  CheckSameLayout(present.observation_layout(), next, fmt::format("the task `{}`", name));
}

void LiveGraph::CheckIsSeenInstead(const Port& present, const Port& next) {
  const auto* before = dynamic_cast<const UniversalTask*>(&present.owner());
  const auto* after = dynamic_cast<const UniversalTask*>(&next.owner());
  if (before == nullptr || &present != &before->observations || after == nullptr) return;
  CheckIsSeen(*before, after->observation_layout(), after->plugin().name);
}

void LiveGraph::CheckSwap(const std::string& name, const Plugin& plugin) const {
  const UniversalTask& task = FindTask(name);
  task.CheckCanSwap(plugin, graph_);
  CheckFitsWorld(plugin, *context_.task);
  CheckIsSeen(task, ObservationLayoutOf(plugin.table()), plugin.table().name);
}

void LiveGraph::Swap(const std::string& name, std::unique_ptr<TaskInstance> instance) {
  CheckSwap(name, *instance->plugin());
  FindTask(name).Swap(std::move(instance), graph_);
}

void LiveGraph::Rollback(const std::string& name) {
  UniversalTask& task = FindTask(name);
  CheckSwap(name, *task.FindPrevious().plugin());
  task.Rollback(graph_);
}

void LiveGraph::CheckPromote(const std::string& name, bool now) const {
  const UniversalTask& task = FindTask(name);
  if (&task == &active_task()) throw UserError(fmt::format("`{}` is active already", name));
  if (now && !task.can_end()) {
    throw UserError(fmt::format(
        "for `{}` this episode is over, or has never begun: promote it without `now`", name));
  }
  CheckIsSeen(active_task(), task.observation_layout(), task.plugin().name);
}

void LiveGraph::Promote(const std::string& name) {
  CheckPromote(name, false);
  UniversalTask& task = FindTask(name);
  UniversalTask& active = active_task();
  MoveConnections(active.reward, task.reward);
  MoveConnections(active.end_of_episode, task.end_of_episode);
  MoveConnections(active.observations, task.observations);
}

const Parameter& LiveGraph::FindParameter(const std::string& parameter) const {
  return runtime::FindParameter(graph_, parameter).parameter;
}

ParameterValue LiveGraph::Get(const std::string& parameter) const {
  const NamedParameter found = runtime::FindParameter(graph_, parameter);
  return found.module.Get(found.parameter.name);
}

void LiveGraph::Set(const std::string& parameter, const ParameterValue& value) {
  SetLive(graph_, parameter, value);
}

LiveGraph::Goal LiveGraph::FindGoal(const std::string& goal) const {
  const size_t dot = goal.find('.');
  if (dot == std::string::npos) {
    throw UserError(
        fmt::format("`{0}` is not a goal: write MODULE.GOAL, such as `task.{0}`", goal));
  }
  UniversalTask& task = FindTask(goal.substr(0, dot));
  return {&task, task.FindGoal(goal.substr(dot + 1))};
}

void LiveGraph::CheckGoal(const std::string& goal) const { FindGoal(goal); }

void LiveGraph::HoldGoal(const std::string& goal, const std::vector<double>& value) {
  const Goal found = FindGoal(goal);
  found.task->HoldGoal(found.goal, value);
}

void LiveGraph::ReleaseGoal(const std::string& goal) {
  const Goal found = FindGoal(goal);
  found.task->ReleaseGoal(found.goal);
}

void LiveGraph::CheckIsUsable(const Port& port, const Port& by) const {
  const std::string why = WhyNotStarted(port.owner().name());
  const bool is_used = port.kind() == PortKind::kOut || port.kind() == PortKind::kSlot ||
                       port.kind() == PortKind::kSignal;
  if (why.empty() || !is_used) return;
  throw UserError(fmt::format("cannot connect `{}` to `{}`: `{}` is not started yet: {}",
                              port.full_name(), by.full_name(), port.owner().name(), why));
}

void LiveGraph::Connect(const std::string& first, const std::string& second) {
  Port& a = graph_.FindPort(first);
  Port& b = graph_.FindPort(second);
  CheckIsUsable(a, b);
  CheckIsUsable(b, a);
  Port& in = a.kind() == PortKind::kIn ? a : b;
  const std::vector<Port*> before = in.Connections();
  const bool replaces =
      in.kind() == PortKind::kIn && !before.empty() && a.Fits(b) && !a.IsConnectedTo(b);
  if (replaces) {
    CheckIsSeenInstead(*before.front(), &in == &a ? b : a);
    Port::Disconnect(in, *before.front());
  }
  graph_.Connect(first, second);
  if (auto* task = dynamic_cast<UniversalTask*>(&in.owner())) task->NoteConnection();
  StartWhatCan();
}

void LiveGraph::Disconnect(const std::string& first, const std::string& second) {
  Port& a = graph_.FindPort(first);
  Port& b = graph_.FindPort(second);
  for (const Port* port : {&a, &b}) {
    if (!port->must_be_connected()) continue;
    throw UserError(fmt::format(
        "`{}` must have a value: connect it to another out port of the type `{}` instead, which "
        "replaces this one",
        port->full_name(), port->type().text));
  }
  CheckIsStillPaid(a, b);
  Port::Disconnect(a, b);
}

// Without the connection of the two.
void LiveGraph::CheckIsStillPaid(const Port& a, const Port& b) const {
  for (const UniversalTask* task : graph_.FindAll<UniversalTask>()) {
    for (const Port* slot : task->reward.Connections()) {
      const bool is_theirs =
          (&task->reward == &a && slot == &b) || (&task->reward == &b && slot == &a);
      if (&slot->owner() == &learner_ && !is_theirs) return;
    }
  }
  throw UserError(fmt::format(
      "without `{}` to `{}` no task pays the learner: promote another task module instead",
      a.full_name(), b.full_name()));
}

std::vector<std::pair<std::string, ParameterValue>> LiveGraph::Resolved(
    const std::string& type, const std::string& name,
    const std::vector<std::pair<std::string, ParameterValue>>& parameters) const {
  const std::unique_ptr<Module> fresh = types_.Make(type, name, context_);
  const std::unique_ptr<Module> module = types_.Make(type, name, context_);
  for (const auto& [parameter, value] : parameters) module->Set(parameter, value);
  std::vector<std::pair<std::string, ParameterValue>> resolved;
  for (const Parameter& parameter : module->parameters()) {
    ParameterValue value = module->Get(parameter.name);
    if (value != fresh->Get(parameter.name))
      resolved.emplace_back(parameter.name, std::move(value));
  }
  return resolved;
}

void LiveGraph::AddModule(const std::string& type, const std::string& name,
                          const std::vector<std::pair<std::string, ParameterValue>>& parameters) {
  std::unique_ptr<Module> module = types_.Make(type, name, context_);
  if (dynamic_cast<UniversalTask*>(module.get()) != nullptr) {
    throw UserError(fmt::format("`{}` is a task module: load a task under this name", name));
  }
  for (const auto& [parameter, value] : parameters) module->Set(parameter, value);
  ConnectSensors(graph_.Add(std::move(module)), graph_);
  not_started_[name] = "";
  StartWhatCan();
}

std::string LiveGraph::WhyNotStarted(const std::string& module) const {
  const auto found = not_started_.find(module);
  return found == not_started_.end() ? "" : found->second;
}

void LiveGraph::StartWhatCan() {
  std::map<std::string, std::string> left;
  for (const auto& [module, why] : not_started_) {
    try {
      graph_.Find(module).Start();
    } catch (const UserError& error) {
      left[module] = error.what();
    }
  }
  not_started_ = std::move(left);
}

void LiveGraph::CheckIsNeeded(const Module& module) const {
  if (&module == &environment_ || &module == &learner_ || &module == &active_task()) {
    throw UserError(fmt::format("the run cannot do without `{}`", module.name()));
  }
  for (const Port* port : module.ports()) {
    if (port->kind() != PortKind::kOut) continue;
    for (const Port* reader : port->Connections()) {
      if (!reader->must_be_connected() || &reader->owner() == &module) continue;
      throw UserError(fmt::format("`{}` is read by `{}`: connect that to another out port first",
                                  port->full_name(), reader->full_name()));
    }
  }
}

void LiveGraph::RemoveModule(const std::string& name) {
  CheckIsNeeded(graph_.Find(name));
  graph_.Remove(name);
  not_started_.erase(name);
}

}  // namespace runtime
