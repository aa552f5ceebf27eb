#include <fmt/format.h>

#include "runtime/core/agent/agent.h"
#include "runtime/core/module/composite.h"
#include "runtime/core/module/load_modules.h"

namespace runtime {
namespace {

// Does `action`, and puts the place in the agent file before its complaints.
template <class Action>
decltype(auto) At(const SourcePlace& place, Action action) {
  try {
    return action();
  } catch (const UserError& error) {
    throw UserError(fmt::format("{}: {}", place.ToText(), error.what()));
  }
}

void AddModule(const ModuleSetting& setting, const ModuleTypes& types, const Context& context,
               ModuleGraph& graph) {
  if (setting.type.empty()) {
    throw UserError(
        fmt::format("{}: the module `{}` has no `type`", setting.place.ToText(), setting.name));
  }
  const ModuleFactory& make =
      At(setting.place, [&]() -> const ModuleFactory& { return types.Find(setting.type); });
  // What is wrong with the robot or the task names its own file.
  std::unique_ptr<Module> made = make(setting.name, context);
  Module& module = At(setting.place, [&]() -> Module& { return graph.Add(std::move(made)); });
  for (const ParameterSetting& parameter : setting.parameters) {
    At(parameter.place, [&] { module.Set(parameter.name, parameter.value); });
  }
}

std::unique_ptr<Module> MakeComposite(const CompositeSetting& setting, const ModuleTypes& types,
                                      const Context& context, std::string name) {
  auto made =
      std::make_unique<Composite>(std::move(name), BuildGraph(setting.inside, types, context));
  for (const ExportSetting& port : setting.ports) {
    At(port.place, [&] { made->ExportPort(port.name, port.inner); });
  }
  for (const ExportSetting& parameter : setting.parameters) {
    At(parameter.place, [&] { made->ExportParameter(parameter.name, parameter.inner); });
  }
  return made;
}

}  // namespace

ModuleTypes WithLibraries(ModuleTypes types, const Agent& agent) {
  for (const LibrarySetting& library : agent.libraries) {
    At(library.place, [&] { LoadModules(library.file, types); });
  }
  return types;
}

// Each composite may use those before it.
ModuleTypes WithComposites(ModuleTypes types, const Agent& agent) {
  for (const CompositeSetting& composite : agent.composites) {
    types.Add(composite.name, [known = types, composite](std::string name, const Context& context) {
      return MakeComposite(composite, known, context, std::move(name));
    });
  }
  return types;
}

ModuleGraph BuildGraph(const Agent& agent, const ModuleTypes& program_types,
                       const Context& context) {
  const ModuleTypes types = WithComposites(program_types, agent);
  ModuleGraph graph;
  for (const ModuleSetting& module : agent.modules) AddModule(module, types, context, graph);
  for (const ConnectionSetting& connection : agent.connections) {
    At(connection.place, [&] { graph.Connect(connection.first, connection.second); });
  }
  return graph;
}

}  // namespace runtime
