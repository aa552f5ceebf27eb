#include "runtime/core/module/connections.h"

#include <fmt/format.h>

#include "runtime/core/module/sensor_data.h"

namespace runtime {

void RequireConnection(const Port& port) {
  if (!port.must_be_connected() || !port.Connections().empty()) return;
  throw UserError(fmt::format("`{}` is not connected: connect it to an out port of the type `{}`",
                              port.full_name(), port.type().text));
}

void RequireConnections(const Module& module) {
  for (const Port* port : module.ports()) RequireConnection(*port);
}

Port* FindOut(const ModuleGraph& graph, std::string_view name, const PortType& type) {
  for (const auto& module : graph.modules()) {
    for (Port* port : module->ports()) {
      if (port->kind() == PortKind::kOut && port->name() == name && port->type() == type)
        return port;
    }
  }
  return nullptr;
}

void ConnectSensors(const Module& module, const ModuleGraph& graph) {
  for (Port* in : module.ports()) {
    const bool is_open = in->kind() == PortKind::kIn && in->Connections().empty();
    if (!is_open || in->type().cpp != typeid(SensorData)) continue;
    Port* out = FindOut(graph, in->name(), in->type());
    if (out != nullptr && &out->owner() != &module) Port::Connect(*out, *in);
  }
}

}  // namespace runtime
