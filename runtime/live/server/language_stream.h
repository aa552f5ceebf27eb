#pragma once

#include <memory>

#include "runtime/base/piped_program.h"
#include "runtime/live/server/web_socket.h"

namespace runtime {

// A language server, as the service's command starts it. Throws HttpError where there is none, or
// too many run already.
std::unique_ptr<PipedProgram> StartLanguageServer(const Service& service);

// Lets the client talk to it: each message is one of the Language Server Protocol, without its
// header. It ends with the connection.
void ServeLanguage(Service& service, Upgrade upgrade, std::unique_ptr<PipedProgram> program);

}  // namespace runtime
