#pragma once

#include "runtime/core/module/module.h"

namespace runtime {

// Throws UserError, naming port and type, if an in port of `module` is not connected.
void RequireConnections(const Module& module);

}  // namespace runtime
