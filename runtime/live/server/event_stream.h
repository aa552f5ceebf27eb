#pragma once

#include "runtime/live/server/web_socket.h"

namespace runtime {

// Sends all events from now on until either side ends it.
void ServeEvents(Service& service, Upgrade upgrade);

}  // namespace runtime
