// Where clients of a running trainer connect: HTTP and WebSocket, on a Unix socket in the run's
// folder and on the loopback. docs/api.md says what is spoken.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "runtime/live/control/request.h"

namespace runtime {

// What keeps one client from overloading the trainer or blocking other clients.
struct ServerLimits {
  std::chrono::milliseconds idle_timeout{
      30'000};                  // with a client that should send or take something
  size_t connections = 64;      // at a time, on each of socket and loopback
  size_t waiting_events = 256;  // for a client that reads them slowly
  size_t body_bytes = 1 << 20;  // of a request
  uint32_t header_bytes = 16 << 10;
};

struct ServerOptions {
  std::filesystem::path folder;  // of the run, which this process has locked
  uint16_t port = 0;             // on 127.0.0.1; 0: any that is free
  int loopback = -1;  // a socket that listens there already, which the server takes; -1: none
  // Program and arguments of a language server for tasks; empty: there is none.
  std::vector<std::string> language_server = {};
  ServerLimits limits = {};
};

// What is made for browsers: the page on which what is served is watched and steered, a run's
// report, and its record's numbers as JSON, which a page draws.
enum class Page { kLive, kReport, kRecord };

// Makes one of them, on a thread of its own, one at a time. `nonce`: an attribute of the scripts
// and styles of the live page; all others are refused by the browser. `run`: which one, where many
// are served. What it throws is told to the client.
using PageMaker =
    std::function<std::string(Page page, const std::string& nonce, const std::string& run)>;

// Serves on threads of its own for as long as it lives. Requests are checked, then passed on; what
// they do is the handler's. The handler must outlive the server; the replies to its requests may
// come later.
class Server : public EventSink {
 public:
  // Throws UserError where the socket, the port or control.json cannot be had.
  Server(const ServerOptions& options, RequestHandler& handler, PageMaker page_maker);
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;
  // Clients get the replies and events that there are already, within half a second.
  ~Server() override;

  void Publish(const nlohmann::json& event) override;
  void Show(const ViewFrame& frame) override;

  // Of the run's page, for a browser; with the token.
  std::string page_address() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace runtime
