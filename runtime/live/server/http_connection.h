#pragma once

#include <memory>

#include "runtime/live/server/descriptor.h"
#include "runtime/live/server/service.h"

namespace runtime {

// Held by a connection that counts toward the limit.
using ConnectionSlot = std::shared_ptr<void>;

// From whom a connection may come.
enum class Transport { kUnixSocket, kLoopback };

// Responds to requests on `socket`, in order, until either side ends it. On the loopback
// each must show that it may ask.
void ServeHttp(Service& service, Descriptor socket, Transport transport, ConnectionSlot slot);

}  // namespace runtime
