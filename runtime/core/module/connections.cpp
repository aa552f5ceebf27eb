#include "runtime/core/module/connections.h"

#include <fmt/format.h>

namespace runtime {

void RequireConnections(const Module& module) {
  for (const Port* port : module.ports()) {
    if (!port->must_be_connected() || !port->Connections().empty()) continue;
    throw UserError(fmt::format("`{}` is not connected: connect it to an out port of the type `{}`",
                                port->full_name(), port->type().text));
  }
}

}  // namespace runtime
