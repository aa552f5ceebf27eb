#include "runtime/live/server/web_socket.h"

#include <boost/asio/buffer.hpp>
#include <boost/beast/websocket.hpp>
#include <utility>

namespace runtime {
namespace {

namespace net = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using boost::system::error_code;

}  // namespace

WebSocket::WebSocket(Service& service, Upgrade upgrade, size_t longest)
    : service_(service),
      websocket_(std::move(upgrade.stream)),
      request_(std::move(upgrade.request)),
      slot_(std::move(upgrade.slot)),
      longest_(longest) {}

void WebSocket::Start() {
  service_.connections.emplace(this, shared_from_this());
  beast::get_lowest_layer(websocket_).expires_never();
  const auto idle_timeout = service_.limits.idle_timeout;
  websocket_.set_option(
      {.handshake_timeout = idle_timeout, .idle_timeout = idle_timeout, .keep_alive_pings = true});
  websocket_.read_message_max(longest_);
  is_sending_ = true;
  websocket_.async_accept(request_, [self = shared_from_this()](error_code error) {
    self->OnSent(error);
    if (!error) self->Read();
  });
}

void WebSocket::End() {
  is_ending_ = true;
  SendWhatThereIs();
}

void WebSocket::Close() {
  OnClose();
  beast::get_lowest_layer(websocket_).close();
  service_.connections.erase(this);
}

// Notices when the client goes, and answers its pings, too.
void WebSocket::Read() {
  websocket_.async_read(buffer_, [self = shared_from_this()](error_code error, size_t) {
    if (error) return self->Close();
    const net::const_buffer bytes = self->buffer_.cdata();
    self->OnMessage({static_cast<const char*>(bytes.data()), bytes.size()});
    self->buffer_.clear();
    self->Read();
  });
}

void WebSocket::SendNext() {
  sending_ = TakeNext();
  is_sending_ = sending_.content != nullptr || is_ending_;
  if (sending_.content != nullptr) {
    websocket_.binary(sending_.is_binary);
    websocket_.async_write(
        net::buffer(*sending_.content),
        [self = shared_from_this()](error_code error, size_t) { self->OnSent(error); });
  } else if (is_ending_) {
    websocket_.async_close({websocket::close_code::going_away, "the trainer ends"},
                           [self = shared_from_this()](error_code) { self->Close(); });
  }
}

void WebSocket::OnSent(error_code error) {
  if (error) return Close();
  SendNext();
}

}  // namespace runtime
