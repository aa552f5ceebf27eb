#include "runtime/training/run/graph_copy.h"

#include <algorithm>
#include <map>
#include <memory>

#include "runtime/core/task/universal_task.h"

namespace runtime {
namespace {

using Copies = std::map<const Module*, Module*>;

// So does not matter to an episode. It may be one that was added to a run and is not connected yet,
// and so not started.
bool IsForItself(const Module& module) {
  return std::ranges::all_of(module.ports(), [](const Port* port) {
    return port->kind() == PortKind::kIn || port->Connections().empty();
  });
}

// A task module is not what its type makes: it may have another task than the run began with.
std::unique_ptr<Module> Another(const UniversalTask& task, const Context& context) {
  const TaskInstance& original = task.instance();
  auto instance = std::make_unique<TaskInstance>(original.plugin(), original.id());
  instance->TakeOver(original, false);
  return std::make_unique<UniversalTask>(task.name(), *context.robot, std::move(instance),
                                         context.seed);
}

void MatchParameters(const Module& original, Module& copy) {
  for (const Parameter& parameter : original.parameters()) {
    const ParameterValue value = original.Get(parameter.name);
    if (copy.Get(parameter.name) != value) copy.Set(parameter.name, value);
  }
}

// The slots of each signal in their order. What is connected inside of a composite already is.
void ConnectLike(const Module& original, const Copies& copies) {
  for (const Port* port : original.ports()) {
    if (port->kind() != PortKind::kSignal && port->kind() != PortKind::kOut) continue;
    for (const Port* peer : port->Connections()) {
      const auto listener = copies.find(&peer->owner());
      if (listener == copies.end()) continue;
      Port& from = copies.at(&original)->FindPort(port->name());
      Port& to = listener->second->FindPort(peer->name());
      if (!from.IsConnectedTo(to)) Port::Connect(from, to);
    }
  }
}

}  // namespace

ModuleGraph CopyOf(const ModuleGraph& graph, const ModuleTypes& types, const Context& context) {
  ModuleGraph copy;
  Copies copies;
  for (const auto& module : graph.modules()) {
    if (IsForItself(*module)) continue;
    const auto* task = dynamic_cast<const UniversalTask*>(module.get());
    copies[module.get()] =
        &copy.Add(task != nullptr ? Another(*task, context)
                                  : types.Make(module->type(), module->name(), context));
    MatchParameters(*module, *copies[module.get()]);
  }
  for (const auto& [original, made] : copies) ConnectLike(*original, copies);
  copy.Start();
  return copy;
}

void CopyParameters(const ModuleGraph& graph, const ModuleGraph& copy) {
  for (const auto& module : copy.modules()) MatchParameters(graph.Find(module->name()), *module);
}

}  // namespace runtime
