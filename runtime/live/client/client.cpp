#include "runtime/live/client/client.h"

#include <fmt/format.h>
#include <sys/socket.h>

#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include "runtime/base/user_error.h"
#include "runtime/live/server/control_socket.h"

namespace runtime {
namespace {

namespace net = boost::asio;
namespace http = boost::beast::http;
namespace websocket = boost::beast::websocket;
using boost::system::error_code;
using nlohmann::json;
using Socket = net::generic::stream_protocol::socket;

constexpr const char* kHost = "localhost";  // HTTP wants one; the socket's path says it all
constexpr uint64_t kMaxReply = 256 << 20;   // far more than any: against a broken trainer

[[noreturn]] void FailBecauseItEnded(const std::filesystem::path& folder, const error_code& error) {
  throw UserError(
      fmt::format("{}: the trainer ended, or closed the connection, before it answered ({}); "
                  "`trainer resume {}` continues a run",
                  folder.string(), error.message(), folder.string()));
}

Socket Connect(net::io_context& io, const std::filesystem::path& folder) {
  Descriptor descriptor = ConnectToTrainer(OpenRunFolder(folder));
  if (!descriptor.is_open()) {
    throw UserError(
        fmt::format("{}: no trainer is running for this run; `trainer resume {}` continues it",
                    folder.string(), folder.string()));
  }
  Socket socket(io);
  socket.assign(net::generic::stream_protocol(AF_UNIX, 0), descriptor.Release());
  return socket;
}

Reply ReadReply(const std::string& text, const std::filesystem::path& folder) {
  const json answer = json::parse(text, nullptr, false);
  if (!answer.is_object() || !answer.contains("ok")) {
    throw UserError(
        fmt::format("{}: cannot understand the trainer's response; is it of another version?",
                    folder.string()));
  }
  return {.ok = answer.value("ok", false),
          .value = answer.value("value", json()),
          .error = answer.value("error", "")};
}

}  // namespace

bool HasTrainer(const std::filesystem::path& folder) {
  return ConnectToTrainer(OpenRunFolder(folder)).is_open();
}

Reply Ask(const std::filesystem::path& folder, const Request& request) {
  net::io_context io;
  Socket socket = Connect(io, folder);
  http::request<http::string_body> message(http::verb::post, "/api/" + request.command, 11);
  message.set(http::field::host, kHost);
  message.keep_alive(false);
  // A file name that is no UTF-8 cannot be sent as it is; the trainer then says that there is none.
  message.body() = request.arguments.dump(-1, ' ', false, json::error_handler_t::replace);
  message.prepare_payload();
  error_code error;
  // What was refused early, such as a body that is too large, is answered even so.
  http::write(socket, message, error);
  boost::beast::flat_buffer buffer;
  http::response_parser<http::string_body> parser;
  parser.body_limit(kMaxReply);
  http::read(socket, buffer, parser, error);
  if (error) FailBecauseItEnded(folder, error);
  return ReadReply(parser.get().body(), folder);
}

void FollowEvents(const std::filesystem::path& folder,
                  const std::function<void(const json&)>& take) {
  net::io_context io;
  websocket::stream<Socket> events(Connect(io, folder));
  error_code error;
  events.handshake(kHost, "/api/events", error);
  if (error) FailBecauseItEnded(folder, error);
  boost::beast::flat_buffer buffer;
  while (events.read(buffer, error), !error) {
    const auto data = buffer.data();
    take(json::parse(std::string_view(static_cast<const char*>(data.data()), data.size())));
    buffer.clear();
  }
}

}  // namespace runtime
