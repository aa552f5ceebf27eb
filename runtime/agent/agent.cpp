#include "runtime/agent/agent.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/module/suggestion.h"

namespace runtime {
namespace {

template <class Setting>
Setting* FindByName(std::vector<Setting>& settings, const std::string& name) {
  const auto found = std::find_if(settings.begin(), settings.end(),
                                  [&](const Setting& setting) { return setting.name == name; });
  return found == settings.end() ? nullptr : &*found;
}

void Apply(const ModuleSetting& change, ModuleSetting& module) {
  for (const ParameterSetting& parameter : change.parameters) {
    if (ParameterSetting* known = FindByName(module.parameters, parameter.name)) {
      *known = parameter;
    } else {
      module.parameters.push_back(parameter);
    }
  }
}

[[noreturn]] void ThrowUnknownModule(const Agent& agent, const ModuleSetting& change) {
  std::vector<std::string> names;
  for (const ModuleSetting& module : agent.modules) names.push_back(module.name);
  throw UserError(
      fmt::format("{}: the agent has no module `{}` to change{} (a new one needs a `type`)",
                  change.place.ToText(), change.name, Suggestion(change.name, names)));
}

// Names may hold characters that TOML allows in quotes only.
std::string Key(const std::string& name) {
  const bool bare = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  });
  return bare ? name : ToText(ParameterValue(name));
}

}  // namespace

std::string SourcePlace::ToText() const { return fmt::format("{}:{}:{}", file, line, column); }

Agent Changed(Agent agent, const Agent& changes) {
  for (const ModuleSetting& change : changes.modules) {
    ModuleSetting* known = FindByName(agent.modules, change.name);
    if (known == nullptr && change.type.empty()) ThrowUnknownModule(agent, change);
    if (known == nullptr) {
      agent.modules.push_back(change);
    } else if (change.type.empty() || change.type == known->type) {
      Apply(change, *known);
    } else {
      *known = change;
    }
  }
  agent.connections.insert(agent.connections.end(), changes.connections.begin(),
                           changes.connections.end());
  return agent;
}

Agent Resolved(const Agent& agent, const Network& network) {
  Agent resolved = agent;
  for (ModuleSetting& setting : resolved.modules) {
    const Module& module = network.Find(setting.name);
    setting.parameters.clear();
    for (const Parameter& parameter : module.parameters()) {
      setting.parameters.push_back({parameter.name, module.Get(parameter.name), setting.place});
    }
  }
  return resolved;
}

std::string ToToml(const Agent& agent) {
  std::string text = "connections = [\n";
  for (const ConnectionSetting& connection : agent.connections) {
    text += fmt::format("  [{}, {}],\n", ToText(ParameterValue(connection.first)),
                        ToText(ParameterValue(connection.second)));
  }
  text += "]\n";
  for (const ModuleSetting& module : agent.modules) {
    text += fmt::format("\n[modules.{}]\n", Key(module.name));
    if (!module.type.empty())
      text += fmt::format("type = {}\n", ToText(ParameterValue(module.type)));
    for (const ParameterSetting& parameter : module.parameters) {
      text += fmt::format("{} = {}\n", Key(parameter.name), ToText(parameter.value));
    }
  }
  return text;
}

}  // namespace runtime
