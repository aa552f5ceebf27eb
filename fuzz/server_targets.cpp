// What clients of a trainer send.
#include <sys/socket.h>

#include "fuzz/runtime_targets.h"
#include "fuzz/targets.h"
#include "runtime/live/control/command_table.h"
#include "runtime/live/server/api.h"
#include "runtime/live/server/control_socket.h"
#include "runtime/live/server/http_error.h"
#include "runtime/live/server/server.h"
#include "tests/runtime/live/server/fake_handler.h"
#include "tests/runtime/live/server/raw_client.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace fuzz {
namespace {

// A server, as long as the program runs.
struct Site {
  runtime::TemporaryFolder folder;
  runtime::FakeHandler handler;
  runtime::Server server{
      {.folder = folder.path()},
      handler,
      [](runtime::Page, const std::string&, const std::string&) { return std::string("a page"); }};

  runtime::RawClient Connect() const {
    return runtime::RawClient(runtime::ConnectToTrainer(runtime::OpenRunFolder(folder.path())));
  }
};

}  // namespace

bool Request(const std::string& text) {
  const size_t first = std::min(text.find('\n'), text.size());
  const size_t second = std::min(text.find('\n', first + 1), text.size());
  const auto piece = [&](size_t begin, size_t end) {
    return std::string_view(text).substr(std::min(begin, text.size()), end - std::min(begin, end));
  };
  const std::string_view target = piece(first + 1, second);
  try {
    const runtime::Route route = runtime::ReadRoute(
        {.method = piece(0, first), .target = target, .body = piece(second + 1, text.size())},
        runtime::Commands());
    if (const auto* request = std::get_if<runtime::Request>(&route)) {
      Require(request->arguments.is_object(), "arguments are no object");
      runtime::ResponseOf(runtime::Reply{.value = request->arguments});
    }
    if (runtime::IsForBrowser(target)) runtime::QueryValue(target, "token");
  } catch (const runtime::HttpError& error) {
    Require(error.status() >= 400 && error.status() < 500, "a client's mistake is called ours");
    runtime::ResponseOf(error.status(), error.what());
    return false;
  }
  return true;
}

bool Frames(const std::string& bytes) {
  static Site& site = *new Site;  // its threads would be waited for at the end
  constexpr const char* kUpgrade =
      "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
      "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nHost: localhost\r\n";
  {
    runtime::RawClient client = site.Connect();
    client.Send(runtime::RequestText("GET", "/api/events", kUpgrade));
    Require(client.Receive().status == 101, "a WebSocket is refused");
    client.Send(bytes);
    shutdown(client.socket().get(), SHUT_WR);
    Require(client.IsClosed(), "a connection stays open that the client has closed");
  }
  runtime::RawClient client = site.Connect();
  client.Send(runtime::RequestText("GET", "/api/status", "Host: localhost\r\n"));
  Require(client.Receive().status == 200, "the server does not answer any more");
  return true;
}

}  // namespace fuzz
