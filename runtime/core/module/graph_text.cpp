#include "runtime/core/module/graph_text.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "runtime/core/module/layout_text.h"

namespace runtime {
namespace {

using Json = nlohmann::ordered_json;

// Calls `visit` with both ports of every connection, the one that speaks first.
template <class Visit>
void ForEachConnection(const Module& module, const Visit& visit) {
  for (const Port* port : module.ports()) {
    if (port->kind() != PortKind::kSignal && port->kind() != PortKind::kOut) continue;
    for (const Port* peer : port->Connections()) visit(*port, *peer);
  }
}

Json ToJson(const ParameterValue& value) {
  return std::visit([](const auto& plain) { return Json(plain); }, value);
}

Json ToJson(const Module& module) {
  Json json = {{"name", module.name()}, {"parameters", Json::object()}, {"ports", Json::array()}};
  for (const Parameter& parameter : module.parameters()) {
    json["parameters"][parameter.name] = ToJson(module.Get(parameter.name));
  }
  for (const Port* port : module.ports()) {
    json["ports"].push_back(
        {{"name", port->name()}, {"kind", ToText(port->kind())}, {"type", port->type().text}});
  }
  if (const auto layout = LayoutShownBy(module)) json["shows"] = ToJson(*layout);
  return json;
}

std::string DotName(const std::string& name) { return ToText(ParameterValue(name)); }

}  // namespace

std::string GraphText(const ModuleGraph& graph) {
  std::string text;
  for (const auto& module : graph.modules()) {
    text += module->name() + "\n";
    for (const Parameter& parameter : module->parameters()) {
      text += fmt::format("  {} = {}\n", parameter.name, ToText(module->Get(parameter.name)));
    }
    if (const auto layout = LayoutShownBy(*module)) text += ToText(*layout, "  shows ");
    ForEachConnection(*module, [&](const Port& from, const Port& to) {
      text += fmt::format("  {} -> {}  {}\n", from.name(), to.full_name(), from.type().text);
    });
  }
  return text;
}

std::string GraphJson(const ModuleGraph& graph) {
  Json json = {{"modules", Json::array()}, {"connections", Json::array()}};
  for (const auto& module : graph.modules()) {
    json["modules"].push_back(ToJson(*module));
    ForEachConnection(*module, [&](const Port& from, const Port& to) {
      json["connections"].push_back(
          {{"from", from.full_name()}, {"to", to.full_name()}, {"type", from.type().text}});
    });
  }
  return json.dump(2) + "\n";
}

std::string GraphDot(const ModuleGraph& graph) {
  std::string text =
      "digraph agent {\n  rankdir=LR;\n  node [shape=box, fontname=\"sans-serif\"];\n";
  text += "  edge [fontname=\"sans-serif\", fontsize=9];\n";
  for (const auto& module : graph.modules()) {
    text += fmt::format("  {};\n", DotName(module->name()));
  }
  for (const auto& module : graph.modules()) {
    ForEachConnection(*module, [&](const Port& from, const Port& to) {
      const bool is_value = from.kind() == PortKind::kOut;
      text +=
          fmt::format("  {} -> {} [taillabel={}, headlabel={}{}];\n", DotName(from.owner().name()),
                      DotName(to.owner().name()), DotName(from.name()), DotName(to.name()),
                      is_value ? ", style=dashed" : "");
    });
  }
  return text + "}\n";
}

}  // namespace runtime
