#include "runtime/live/server/loopback.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>

#include "runtime/base/user_error.h"

namespace runtime {

Descriptor ListenOnLoopback(uint16_t port) {
  Descriptor socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  constexpr int kIsReused = 1;
  setsockopt(socket.get(), SOL_SOCKET, SO_REUSEADDR, &kIsReused, sizeof(kIsReused));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0 &&
      listen(socket.get(), SOMAXCONN) == 0) {
    return socket;
  }
  throw UserError(
      fmt::format("port {} of 127.0.0.1: cannot listen: {}; choose another with `--port`", port,
                  std::strerror(errno)));
}

uint16_t PortOf(const Descriptor& socket) {
  sockaddr_in address{};
  socklen_t size = sizeof(address);
  getsockname(socket.get(), reinterpret_cast<sockaddr*>(&address), &size);
  return ntohs(address.sin_port);
}

}  // namespace runtime
