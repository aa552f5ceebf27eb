#include "runtime/live/server/listener.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <cerrno>
#include <string_view>

namespace runtime {
namespace {

// How long no client is taken where the system has no more descriptors or memory.
constexpr std::chrono::milliseconds kPause{100};

constexpr std::string_view kFull =
    "HTTP/1.1 503 Service Unavailable\r\nContent-Length: 0\r\nConnection: close\r\n\r\n";

constexpr int kYes = 1;

}  // namespace

Listener::Listener(Service& service, Descriptor socket, Transport transport)
    : service_(service),
      socket_(service.io, socket.Release()),
      pause_(service.io),
      transport_(transport) {}

void Listener::Accept() {
  socket_.async_wait(socket_.wait_read, [this](const boost::system::error_code& error) {
    if (!error) AcceptAll();
  });
}

void Listener::Close() {
  pause_.cancel();
  socket_.close();
}

// Not by Asio, whose sockets a taskc that the trainer starts would inherit.
void Listener::AcceptAll() {
  while (true) {
    Descriptor client(
        accept4(socket_.native_handle(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
    if (client.is_open()) {
      Take(std::move(client));
    } else if (errno == EAGAIN) {
      return Accept();
    } else if (errno != EINTR && errno != ECONNABORTED) {
      return TryAgainLater();
    }
  }
}

void Listener::TryAgainLater() {
  pause_.expires_after(kPause);
  pause_.async_wait([this](const boost::system::error_code& error) {
    if (!error) Accept();
  });
}

void Listener::Take(Descriptor client) {
  if (slots_.use_count() > static_cast<long>(service_.limits.connections)) {
    send(client.get(), kFull.data(), kFull.size(), MSG_NOSIGNAL);  // a new socket has room for it
    return;
  }
  if (transport_ == Transport::kLoopback) {
    setsockopt(client.get(), IPPROTO_TCP, TCP_NODELAY, &kYes, sizeof(kYes));
  }
  ServeHttp(service_, std::move(client), transport_, slots_);
}

}  // namespace runtime
