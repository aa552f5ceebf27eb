// A client that sends whatever bytes a test wants, right or wrong.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "runtime/live/server/descriptor.h"

namespace runtime {

struct RawResponse {
  int status = 0;      // 0: the connection ended before there was one
  std::string header;  // all lines
  std::string body;
};

class RawClient {
 public:
  explicit RawClient(Descriptor socket) : socket_(std::move(socket)) {}
  static RawClient ToPort(int port);

  // False where the other side has closed.
  bool Send(std::string_view bytes);
  // Waits ten seconds at most.
  RawResponse Receive();
  // Of a connection that has become a WebSocket: a text to the server, and the next message of it,
  // of whatever kind but a ping; "" where there is none within ten seconds.
  bool SendText(std::string_view text);
  std::string ReceiveMessage();
  // Waits ten seconds at most for the other side to close; what it sends is ignored.
  bool IsClosed();
  const Descriptor& socket() const { return socket_; }

 private:
  // The first frame of what was received; nothing where it is not whole yet.
  struct Frame {
    bool is_ping;
    bool is_last;  // of its message
    std::string content;
  };
  std::optional<Frame> TakeFrame();
  bool ReadMore();

  Descriptor socket_;
  std::string received_;
};

// An HTTP request with its body.
std::string RequestText(std::string_view method, std::string_view target, std::string_view header,
                        std::string_view body = "");

}  // namespace runtime
