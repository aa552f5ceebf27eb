// What the tests of the server share: a server in a folder of its own, and clients of it.
#pragma once

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "runtime/live/client/client.h"
#include "runtime/live/server/control_socket.h"
#include "runtime/live/server/server.h"
#include "tests/runtime/live/server/fake_handler.h"
#include "tests/runtime/live/server/raw_client.h"
#include "tests/runtime/training/run/error_of.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {

inline constexpr const char* kUpgrade =
    "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
    "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";

class ServerTest : public testing::Test {
 protected:
  void Start(const ServerLimits& limits = {}) { Start({.folder = folder(), .limits = limits}); }
  // Pages say what they are.
  void Start(const ServerOptions& options) {
    server_.emplace(options, handler_,
                    [](Page page, const std::string& nonce, const std::string& run) -> std::string {
                      if (page == Page::kLive) return "<html>live, nonce " + nonce + "</html>";
                      return page == Page::kReport ? "<html>a report" + run + "</html>"
                                                   : "{\"a\":1}";
                    });
    const nlohmann::json control = ControlFileContent();
    token_ = control["token"];
    const std::string url = control["url"];
    port_ = std::stoi(url.substr(url.rfind(':') + 1));
  }

  const std::filesystem::path& folder() const { return folder_.path(); }

  nlohmann::json ControlFileContent() const {
    std::ifstream in(folder() / "control.json");
    return nlohmann::json::parse(in);
  }

  RawClient OnSocket() const { return RawClient(ConnectToTrainer(OpenRunFolder(folder()))); }
  RawClient OnPort() const { return RawClient::ToPort(port_); }

  std::string Host() const { return "Host: 127.0.0.1:" + std::to_string(port_) + "\r\n"; }
  // All that a request on the loopback must say.
  std::string Credentials() const { return Host() + "Authorization: Bearer " + token_ + "\r\n"; }

  // A connection that has become a WebSocket.
  RawClient OnWebSocket(const std::string& path) const {
    RawClient client = OnPort();
    client.Send(RequestText("GET", path + "?token=" + token_, Host() + kUpgrade));
    EXPECT_EQ(client.Receive().status, 101);
    return client;
  }

  // On the loopback, in a connection of its own.
  RawResponse ResponseTo(std::string_view method, std::string_view target,
                         const std::string& header, std::string_view body = "") const {
    RawClient client = OnPort();
    client.Send(RequestText(method, target, header, body));
    return client.Receive();
  }

  static std::string ErrorIn(const RawResponse& response) {
    return nlohmann::json::parse(response.body).value("error", "");
  }

  TemporaryFolder folder_;
  FakeHandler handler_;
  std::optional<Server> server_;
  std::string token_;
  int port_ = 0;
};

}  // namespace runtime
