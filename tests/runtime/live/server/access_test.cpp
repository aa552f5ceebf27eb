// Who may ask.
#include "runtime/live/server/access.h"

#include <sys/stat.h>
#include <unistd.h>

#include "tests/runtime/live/server/server_test.h"

namespace runtime {
namespace {

using testing::HasSubstr;
using testing::Not;

class AccessTest : public ServerTest {
 protected:
  int Status(const std::string& header) const {
    return ResponseTo("POST", "/api/status", header).status;
  }
  std::string Bearer(const std::string& token) const {
    return Host() + "Authorization: Bearer " + token + "\r\n";
  }
};

TEST_F(AccessTest, TheTokenIsNeeded) {
  Start();
  EXPECT_EQ(Status(Credentials()), 200);
  EXPECT_EQ(Status(Host()), 401);
  EXPECT_EQ(Status(Bearer("")), 401);
  EXPECT_EQ(Status(Bearer(token_ + "0")), 401);
  EXPECT_EQ(Status(Bearer(token_.substr(1))), 401);
  EXPECT_EQ(Status(Bearer(std::string(token_.size(), '0'))), 401);
  EXPECT_EQ(Status(Host() + "Authorization: " + token_ + "\r\n"), 401);
  EXPECT_EQ(handler_.count(), 1);
}

TEST_F(AccessTest, ATokenIsLongAndNewEachTime) {
  Start();
  const std::string first = token_;
  EXPECT_EQ(first.size(), 64u);
  server_.reset();
  Start();
  EXPECT_NE(first, token_);
}

TEST_F(AccessTest, OnlyABrowserMayHaveTheTokenInItsAddress) {
  Start();
  EXPECT_EQ(ResponseTo("GET", "/?token=" + token_, Host()).status, 200);
  EXPECT_EQ(ResponseTo("GET", "/?token=" + token_.substr(1), Host()).status, 401);
  EXPECT_EQ(ResponseTo("GET", "/", Host()).status, 401);
  EXPECT_EQ(ResponseTo("GET", "/report?token=" + token_, Host()).status, 200);
  EXPECT_EQ(ResponseTo("GET", "/api/record?token=" + token_, Host()).status, 401);
  for (const std::string stream : {"/api/events", "/api/view", "/api/language"}) {
    EXPECT_EQ(ResponseTo("GET", stream + "?token=" + token_, Host()).status, 426) << stream;
    EXPECT_EQ(ResponseTo("GET", stream, Host()).status, 401) << stream;
  }
  EXPECT_EQ(ResponseTo("GET", "/api/status?token=" + token_, Host()).status, 401);
  EXPECT_EQ(server_->page_address(),
            "http://127.0.0.1:" + std::to_string(port_) + "/?token=" + token_);
}

TEST_F(AccessTest, TheHostMustBeOurs) {
  Start();
  const std::string bearer = "Authorization: Bearer " + token_ + "\r\n";
  const std::string port = std::to_string(port_);
  EXPECT_EQ(Status("Host: localhost:" + port + "\r\n" + bearer), 200);
  for (const std::string& host :
       {"evil.example:" + port, std::string("127.0.0.1"), "127.0.0.1:1" + port, std::string(),
        "127.0.0.1:" + port + ".evil.example"}) {
    EXPECT_EQ(Status("Host: " + host + "\r\n" + bearer), 403) << host;
  }
  EXPECT_EQ(Status(bearer), 403);
}

TEST_F(AccessTest, AnOriginMustBeOurs) {
  Start();
  const std::string port = std::to_string(port_);
  EXPECT_EQ(Status(Credentials() + "Origin: http://127.0.0.1:" + port + "\r\n"), 200);
  EXPECT_EQ(Status(Credentials() + "Origin: http://localhost:" + port + "\r\n"), 200);
  for (const std::string& origin : {"https://127.0.0.1:" + port, std::string("http://evil.example"),
                                    std::string("null"), "http://127.0.0.1:" + port + "0"}) {
    EXPECT_EQ(Status(Credentials() + "Origin: " + origin + "\r\n"), 403) << origin;
  }
}

TEST_F(AccessTest, AHeaderThatDecidesStandsThereOnce) {
  Start();
  const std::string port = std::to_string(port_);
  const std::string origin = "Origin: http://127.0.0.1:" + port + "\r\n";
  const std::string authorization = "authorization: Bearer " + token_ + "\r\n";
  EXPECT_EQ(Status(Credentials() + origin), 200);
  EXPECT_EQ(Status(Credentials() + origin + "X-Other: 1\r\nX-Other: 2\r\n"), 200);
  for (const std::string& second :
       {std::string("Host: evil.example\r\n"), "host: 127.0.0.1:" + port + "\r\n",
        std::string("ORIGIN: http://evil.example\r\n"), origin, authorization}) {
    EXPECT_EQ(Status(Credentials() + origin + second), 400) << second;
    EXPECT_EQ(Status(second + Credentials() + origin), 400) << second;
  }
  EXPECT_EQ(handler_.count(), 2);
}

// A wrong sender is told so before it has sent megabytes.
TEST_F(AccessTest, IsCheckedBeforeTheBodyIsRead) {
  Start();
  RawClient client = OnPort();
  client.Send("POST /api/status HTTP/1.1\r\n" + Host() + "Content-Length: 1000000\r\n\r\n");
  EXPECT_EQ(client.Receive().status, 401);
  EXPECT_TRUE(client.IsClosed());
}

TEST_F(AccessTest, TheSocketNeedsNeitherTokenNorHost) {
  Start();
  RawClient client = OnSocket();
  client.Send(RequestText("POST", "/api/status", ""));
  EXPECT_EQ(client.Receive().status, 200);
}

TEST_F(AccessTest, FilesAreForTheOwnerOnly) {
  const mode_t before = umask(0);
  Start();
  umask(before);
  for (const char* name : {"control.sock", "control.json"}) {
    struct stat status {};
    ASSERT_EQ(lstat((folder() / name).c_str(), &status), 0) << name;
    EXPECT_EQ(status.st_mode & 0777, 0600u) << name;
  }
}

TEST_F(AccessTest, TheControlFileSaysHowToReachTheTrainer) {
  Start();
  const nlohmann::json control = ControlFileContent();
  EXPECT_EQ(control["url"], "http://127.0.0.1:" + std::to_string(port_) + "/");
  EXPECT_EQ(control["pid"], getpid());
  EXPECT_EQ(control.size(), 3u);
}

TEST_F(AccessTest, AnErrorDoesNotShowTheToken) {
  Start();
  const RawResponse response = ResponseTo("POST", "/api/status", Host());
  EXPECT_THAT(ErrorIn(response), HasSubstr("control.json"));
  EXPECT_THAT(response.body + response.header, Not(HasSubstr(token_)));
}

}  // namespace
}  // namespace runtime
