#pragma once

#include "runtime/live/server/web_socket.h"

namespace runtime {

// Shows the robot as the client wishes, which says `instants`, `episode` or `nothing`, until either
// side ends it.
void ServeView(Service& service, Upgrade upgrade);

}  // namespace runtime
