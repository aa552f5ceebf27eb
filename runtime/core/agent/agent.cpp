#include "runtime/core/agent/agent.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "runtime/base/suggestion.h"
#include "runtime/core/module/composite.h"

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

std::string Quoted(const std::string& text) { return ToText(ParameterValue(text)); }

// Writes agents as TOML, if wanted with the places where things come from as comments.
class TomlWriter {
 public:
  explicit TomlWriter(bool with_places) : with_places_(with_places) {}

  std::string Write(const Agent& agent) {
    WriteLibraries(agent);
    WriteConnections(agent);
    WriteModules(agent, "modules");
    for (const CompositeSetting& composite : agent.composites) {
      const std::string table = "composites." + Key(composite.name);
      text_ += "\n";
      Line(fmt::format("[{}]", table), &composite.place);
      WriteConnections(composite.inside);
      WriteExports("ports", composite.ports);
      WriteExports("parameters", composite.parameters);
      WriteModules(composite.inside, table + ".modules");
    }
    return std::move(text_);
  }

 private:
  void Line(const std::string& line, const SourcePlace* place = nullptr) {
    constexpr int kColumn = 52;
    if (with_places_ && place != nullptr) {
      const std::string origin = place->file.empty() ? "default" : place->ToText();
      text_ += fmt::format("{:<{}}  # {}\n", line, kColumn, origin);
    } else {
      text_ += line + "\n";
    }
  }

  void WriteLibraries(const Agent& agent) {
    if (agent.libraries.empty()) return;
    Line("libraries = [");
    for (const LibrarySetting& library : agent.libraries) {
      Line(fmt::format("  {},", Quoted(library.file)), &library.place);
    }
    Line("]");
  }

  void WriteConnections(const Agent& agent) {
    Line("connections = [");
    for (const ConnectionSetting& connection : agent.connections) {
      Line(fmt::format("  [{}, {}],", Quoted(connection.first), Quoted(connection.second)),
           &connection.place);
    }
    Line("]");
  }

  void WriteExports(std::string_view key, const std::vector<ExportSetting>& exports) {
    std::vector<std::string> pairs;
    for (const ExportSetting& each : exports) {
      pairs.push_back(fmt::format("{} = {}", Key(each.name), Quoted(each.inner)));
    }
    Line(fmt::format("{} = {{{}}}", key, fmt::join(pairs, ", ")));
  }

  void WriteModules(const Agent& agent, const std::string& table) {
    for (const ModuleSetting& module : agent.modules) {
      text_ += "\n";
      Line(fmt::format("[{}.{}]", table, Key(module.name)), &module.place);
      if (!module.type.empty()) Line(fmt::format("type = {}", Quoted(module.type)));
      for (const ParameterSetting& parameter : module.parameters) {
        Line(fmt::format("{} = {}", Key(parameter.name), ToText(parameter.value)),
             &parameter.place);
      }
    }
  }

  const bool with_places_;
  std::string text_;
};

}  // namespace

std::string SourcePlace::ToText() const {
  return line == 0 ? file : fmt::format("{}:{}:{}", file, line, column);
}

Agent Changed(Agent agent, const Agent& changes) {
  if (changes.is_whole) agent = Agent();
  for (const ModuleSetting& change : changes.modules) {
    const bool is_known = FindByName(agent.modules, change.name) != nullptr;
    if (!is_known && change.type.empty()) ThrowUnknownModule(agent, change);
  }
  return Joined(std::move(agent), changes);
}

Agent Joined(Agent agent, const Agent& changes) {
  agent.is_whole = agent.is_whole || changes.is_whole;
  for (const LibrarySetting& library : changes.libraries) {
    const auto known = std::ranges::find(agent.libraries, library.file, &LibrarySetting::file);
    if (known == agent.libraries.end()) agent.libraries.push_back(library);
  }
  for (const ModuleSetting& change : changes.modules) {
    ModuleSetting* known = FindByName(agent.modules, change.name);
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
  for (const CompositeSetting& composite : changes.composites) {
    if (CompositeSetting* known = FindByName(agent.composites, composite.name)) {
      *known = composite;
    } else {
      agent.composites.push_back(composite);
    }
  }
  return agent;
}

Agent Resolved(const Agent& agent, const ModuleGraph& graph) {
  Agent resolved = agent;
  for (ModuleSetting& setting : resolved.modules) {
    const Module& module = graph.Find(setting.name);
    std::vector<ParameterSetting> given = std::exchange(setting.parameters, {});
    for (const Parameter& parameter : module.parameters()) {
      const ParameterSetting* known = FindByName(given, parameter.name);
      setting.parameters.push_back({parameter.name, module.Get(parameter.name),
                                    known != nullptr ? known->place : SourcePlace{}});
    }
    // What a composite does not export is the same in all modules of its type.
    const auto* composite = dynamic_cast<const Composite*>(&module);
    if (composite == nullptr) continue;
    CompositeSetting& type = *FindByName(resolved.composites, setting.type);
    type.inside = Resolved(type.inside, composite->inner());
  }
  return resolved;
}

std::string ToToml(const Agent& agent) { return TomlWriter(false).Write(agent); }

std::string ToTomlWithPlaces(const Agent& agent) { return TomlWriter(true).Write(agent); }

}  // namespace runtime
