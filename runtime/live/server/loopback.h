#pragma once

#include <cstdint>

#include "runtime/live/server/descriptor.h"

namespace runtime {

// Listens on 127.0.0.1 without ever blocking. Port 0 stands for any that is free. Throws UserError.
Descriptor ListenOnLoopback(uint16_t port);
uint16_t PortOf(const Descriptor& socket);

}  // namespace runtime
