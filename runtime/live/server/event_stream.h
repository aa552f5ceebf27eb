#pragma once

#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>

#include "runtime/live/server/http_connection.h"
#include "runtime/live/server/service.h"
#include "runtime/live/server/socket.h"

namespace runtime {

// Turns the connection on which `request` came into a WebSocket, and sends all events from now on
// until either side ends it.
void ServeEvents(Service& service, Stream stream,
                 boost::beast::http::request<boost::beast::http::string_body> request,
                 ConnectionSlot slot);

}  // namespace runtime
