// A client's WebSocket. Its messages are sent one after the other, as fast as the client takes
// them; whoever has them decides which to keep until then. Used on the io thread only.
#pragma once

#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <memory>
#include <string>
#include <string_view>

#include "runtime/live/server/http_connection.h"
#include "runtime/live/server/service.h"
#include "runtime/live/server/socket.h"

namespace runtime {

// A connection that has asked to become a WebSocket.
struct Upgrade {
  Stream stream;
  boost::beast::http::request<boost::beast::http::string_body> request;
  ConnectionSlot slot;
};

class WebSocket : public Connection, public std::enable_shared_from_this<WebSocket> {
 public:
  // `longest`: of a client's messages [bytes]; one that sends a longer one is let go.
  WebSocket(Service& service, Upgrade upgrade, size_t longest);

  // Makes it one of the service's connections. To be called once.
  void Start();

  void End() override;
  void Close() override;

 protected:
  struct Message {
    std::shared_ptr<const std::string> content;  // null: there is none now
    bool is_binary = false;
  };

  virtual Message TakeNext() = 0;
  virtual void OnMessage(std::string_view /*content*/) {}
  // It is closed; called once at least.
  virtual void OnClose() {}

  // To be called whenever there may be a message where there was none.
  void SendWhatThereIs() {
    if (!is_sending_) SendNext();
  }

  Service& service_;

 private:
  void Read();
  void SendNext();
  void OnSent(boost::system::error_code error);

  boost::beast::websocket::stream<Stream> websocket_;
  boost::beast::http::request<boost::beast::http::string_body> request_;
  ConnectionSlot slot_;
  const size_t longest_;
  boost::beast::flat_buffer buffer_;
  Message sending_;
  bool is_sending_ = false;
  bool is_ending_ = false;
};

}  // namespace runtime
