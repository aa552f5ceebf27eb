#include "runtime/live/server/http_connection.h"

#include <fmt/format.h>

#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <optional>

#include "runtime/live/server/api.h"
#include "runtime/live/server/event_stream.h"
#include "runtime/live/server/http_error.h"
#include "runtime/live/server/language_stream.h"
#include "runtime/live/server/socket.h"
#include "runtime/live/server/view_stream.h"

namespace runtime {
namespace {

namespace net = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using boost::system::error_code;

// How long a client that was refused may go on sending, before its connection is closed on it: a
// connection that is closed with bytes unread may lose the response.
constexpr std::chrono::seconds kLinger{1};

constexpr std::string_view kContinue = "HTTP/1.1 100 Continue\r\n\r\n";

class HttpConnection final : public Connection,
                             public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(Service& service, Stream stream, Transport transport, ConnectionSlot slot)
      : service_(service),
        stream_(std::move(stream)),
        transport_(transport),
        slot_(std::move(slot)) {}

  void Read();
  void End() override;
  void Close() override;

 private:
  using Message = http::request<http::string_body>;

  // For the end of an operation; the connection lives until then.
  auto Then(void (HttpConnection::*method)(error_code)) {
    return
        [self = shared_from_this(), method](error_code error, size_t) { ((*self).*method)(error); };
  }

  const Message& message() const { return parser_->get(); }
  std::string_view Header(http::field field) const { return message()[field]; }

  void OnHeader(error_code error);
  void ReadBody(error_code error);
  void OnBody(error_code error);
  void OnReadError(error_code error);
  void CheckAccess() const;

  void Do(Route route);
  void Pass(Request request);
  void SendPage(PageRoute route);
  void BecomeStream(StreamRoute route);

  void Refuse(HttpResponse response);
  void Send(HttpResponse response);
  static void SendLater(Service& service, std::weak_ptr<HttpConnection> self,
                        HttpResponse response);
  void OnSent(error_code error);
  void DiscardTheRest(error_code error);

  Service& service_;
  Stream stream_;
  const Transport transport_;
  ConnectionSlot slot_;
  beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::string_body>> parser_;
  std::optional<http::response<http::string_body>> response_;
  bool is_sending_ = false;
  bool is_ending_ = false;  // after the current response
};

void HttpConnection::Read() {
  parser_.emplace();
  parser_->header_limit(service_.limits.header_bytes);
  parser_->body_limit(service_.limits.body_bytes);
  stream_.expires_after(service_.limits.idle_timeout);
  http::async_read_header(stream_, buffer_, *parser_, Then(&HttpConnection::OnHeader));
}

void HttpConnection::End() {
  is_ending_ = true;
  if (!is_sending_) Close();
}

void HttpConnection::Close() {
  stream_.close();
  service_.connections.erase(this);
}

// What stands before a request's body is enough to refuse it.
void HttpConnection::OnHeader(error_code error) {
  if (error) return OnReadError(error);
  try {
    CheckAccess();
  } catch (const HttpError& refusal) {
    return Refuse(ResponseOf(refusal.status(), refusal.what()));
  }
  if (!beast::iequals(Header(http::field::expect), "100-continue")) return ReadBody({});
  net::async_write(stream_, net::buffer(kContinue), Then(&HttpConnection::ReadBody));
}

void HttpConnection::ReadBody(error_code error) {
  if (error) return OnReadError(error);
  stream_.expires_after(service_.limits.idle_timeout);  // before, it may have been idle
  http::async_read(stream_, buffer_, *parser_, Then(&HttpConnection::OnBody));
}

void HttpConnection::OnBody(error_code error) {
  if (error) return OnReadError(error);
  stream_.expires_never();
  try {
    Do(ReadRoute({.method = message().method_string(),
                  .target = message().target(),
                  .body = message().body()},
                 service_.handler.commands()));
  } catch (const HttpError& refusal) {
    Send(ResponseOf(refusal.status(), refusal.what()));
  }
}

void HttpConnection::OnReadError(error_code error) {
  if (error == http::error::body_limit) {
    return Refuse(ResponseOf(413, "the request's body is too large"));
  }
  if (error == http::error::header_limit) {
    return Refuse(ResponseOf(431, "the request's header is too large"));
  }
  const bool is_of_http = error.category() == make_error_code(http::error::bad_method).category();
  const bool is_gone = error == http::error::end_of_stream || error == http::error::partial_message;
  if (!is_of_http || is_gone) return Close();
  Refuse(ResponseOf(400, "this is not HTTP: " + error.message()));
}

void HttpConnection::CheckAccess() const {
  if (transport_ == Transport::kUnixSocket) return;  // the system lets only its owner in
  for (const http::field field :
       {http::field::host, http::field::origin, http::field::authorization}) {
    if (message().count(field) < 2) continue;
    // Whoever stands between may have looked at the other one.
    throw HttpError(400, fmt::format("the header `{}` occurs more than once",
                                     std::string_view(http::to_string(field))));
  }
  const std::string_view target = message().target();
  const std::string token = IsForBrowser(target) ? QueryValue(target, "token") : "";
  service_.access.Check({.host = Header(http::field::host),
                         .origin = Header(http::field::origin),
                         .authorization = Header(http::field::authorization),
                         .token = token});
}

void HttpConnection::Do(Route route) {
  if (auto* page = std::get_if<PageRoute>(&route)) {
    SendPage(std::move(*page));
  } else if (const auto* stream = std::get_if<StreamRoute>(&route)) {
    BecomeStream(*stream);
  } else {
    Pass(std::move(std::get<Request>(route)));
  }
}

// The reply may come on any thread, and when neither connection nor server are there any more.
void HttpConnection::Pass(Request request) {
  service_.handler.Handle(std::move(request), [service = service_.weak_from_this(),
                                               self = weak_from_this()](const Reply& reply) {
    if (const auto living = service.lock()) SendLater(*living, self, ResponseOf(reply));
  });
}

void HttpConnection::SendPage(PageRoute route) {
  const std::string host(Header(http::field::host));
  net::post(service_.pages,
            [&service = service_, self = weak_from_this(), route = std::move(route), host] {
              HttpResponse response;
              try {
                response = MakePage(service.page_maker, route, host);
              } catch (const std::exception& error) {
                response = ResponseOf(500, error.what());
              }
              SendLater(service, self, std::move(response));
            });
}

void HttpConnection::BecomeStream(StreamRoute route) {
  if (!beast::websocket::is_upgrade(message())) {
    return Send(ResponseOf(426, "this comes over a WebSocket"));
  }
  auto language_server = route == StreamRoute::kLanguage ? StartLanguageServer(service_) : nullptr;
  Upgrade upgrade{std::move(stream_), message(), std::move(slot_)};
  switch (route) {
    case StreamRoute::kEvents:
      ServeEvents(service_, std::move(upgrade));
      break;
    case StreamRoute::kView:
      ServeView(service_, std::move(upgrade));
      break;
    case StreamRoute::kLanguage:
      ServeLanguage(service_, std::move(upgrade), std::move(language_server));
      break;
  }
  service_.connections.erase(this);
}

// Answers a request that was not read to its end.
void HttpConnection::Refuse(HttpResponse response) {
  is_ending_ = true;
  Send(std::move(response));
}

void HttpConnection::Send(HttpResponse response) {
  auto& written = response_.emplace(static_cast<http::status>(response.status), 11);
  written.set(http::field::content_type, response.type);
  written.set(http::field::cache_control, "no-store");
  written.set("Referrer-Policy", "no-referrer");  // the page's address has the token
  written.set("X-Content-Type-Options", "nosniff");
  written.set("X-Frame-Options", "DENY");
  if (!response.policy.empty()) written.set("Content-Security-Policy", response.policy);
  written.body() = std::move(response.body);
  is_ending_ = is_ending_ || !message().keep_alive();
  written.keep_alive(!is_ending_);
  written.prepare_payload();
  is_sending_ = true;
  stream_.expires_after(service_.limits.idle_timeout);
  http::async_write(stream_, written, Then(&HttpConnection::OnSent));
}

void HttpConnection::SendLater(Service& service, std::weak_ptr<HttpConnection> self,
                               HttpResponse response) {
  net::post(service.io, [self = std::move(self), response = std::move(response)]() mutable {
    if (const auto living = self.lock()) living->Send(std::move(response));
  });
}

void HttpConnection::OnSent(error_code error) {
  is_sending_ = false;
  if (error) return Close();
  if (!is_ending_) return Read();
  error_code ignored;
  stream_.socket().shutdown(net::socket_base::shutdown_send, ignored);
  stream_.expires_after(kLinger);
  DiscardTheRest({});
}

void HttpConnection::DiscardTheRest(error_code error) {
  if (error || service_.is_ending) return Close();
  buffer_.clear();
  stream_.async_read_some(buffer_.prepare(4096), Then(&HttpConnection::DiscardTheRest));
}

}  // namespace

void ServeHttp(Service& service, Descriptor socket, Transport transport, ConnectionSlot slot) {
  const int family = transport == Transport::kUnixSocket ? AF_UNIX : AF_INET;
  Stream stream(service.io);
  stream.socket().assign(net::generic::stream_protocol(family, 0), socket.Release());
  const auto connection =
      std::make_shared<HttpConnection>(service, std::move(stream), transport, std::move(slot));
  service.connections.emplace(connection.get(), connection);
  connection->Read();
}

}  // namespace runtime
