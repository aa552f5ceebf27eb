#include "runtime/live/server/event_stream.h"

#include <boost/asio/buffer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket.hpp>

namespace runtime {
namespace {

namespace net = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using boost::system::error_code;

constexpr size_t kMaxMessage = 4096;  // from the client, which has nothing to say

class EventStream final : public Connection,
                          public EventListener,
                          public std::enable_shared_from_this<EventStream> {
 public:
  EventStream(Service& service, Stream stream,
              beast::http::request<beast::http::string_body> request, ConnectionSlot slot)
      : service_(service),
        websocket_(std::move(stream)),
        request_(std::move(request)),
        slot_(std::move(slot)),
        events_(service.limits.waiting_events) {}

  // Events of this moment count already; they are sent when the client has been accepted.
  void Start() {
    service_.events.Add(*this);
    beast::get_lowest_layer(websocket_).expires_never();
    const auto idle_timeout = service_.limits.idle_timeout;
    websocket_.set_option({.handshake_timeout = idle_timeout,
                           .idle_timeout = idle_timeout,
                           .keep_alive_pings = true});
    websocket_.read_message_max(kMaxMessage);
    websocket_.text(true);
    is_sending_ = true;
    websocket_.async_accept(request_, [self = shared_from_this()](error_code error) {
      self->OnSent(error);
      if (!error) self->Read();
    });
  }

  void Take(const EventText& event) override {
    events_.Push(event);
    if (!is_sending_) SendNext();
  }

  void End() override {
    is_ending_ = true;
    if (!is_sending_) SendNext();
  }

  void Close() override {
    service_.events.Remove(*this);
    beast::get_lowest_layer(websocket_).close();
    service_.connections.erase(this);
  }

 private:
  // Notices when the client goes, and answers its pings.
  void Read() {
    websocket_.async_read(buffer_, [self = shared_from_this()](error_code error, size_t) {
      if (error) return self->Close();
      self->buffer_.clear();
      self->Read();
    });
  }

  void SendNext() {
    sending_ = events_.Pop();
    is_sending_ = sending_ || is_ending_;
    if (sending_) {
      websocket_.async_write(
          net::buffer(*sending_),
          [self = shared_from_this()](error_code error, size_t) { self->OnSent(error); });
    } else if (is_ending_) {
      websocket_.async_close({websocket::close_code::going_away, "the trainer ends"},
                             [self = shared_from_this()](error_code) { self->Close(); });
    }
  }

  void OnSent(error_code error) {
    if (error) return Close();
    SendNext();
  }

  Service& service_;
  websocket::stream<Stream> websocket_;
  beast::http::request<beast::http::string_body> request_;
  ConnectionSlot slot_;
  beast::flat_buffer buffer_;
  EventQueue events_;
  EventText sending_;
  bool is_sending_ = false;
  bool is_ending_ = false;
};

}  // namespace

void ServeEvents(Service& service, Stream stream,
                 beast::http::request<beast::http::string_body> request, ConnectionSlot slot) {
  const auto connection = std::make_shared<EventStream>(service, std::move(stream),
                                                        std::move(request), std::move(slot));
  service.connections.emplace(connection.get(), connection);
  connection->Start();
}

}  // namespace runtime
