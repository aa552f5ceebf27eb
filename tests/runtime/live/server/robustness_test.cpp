// Clients that are wrong, slow, or many.
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <random>
#include <thread>

#include "tests/runtime/live/server/server_test.h"

namespace runtime {
namespace {

using nlohmann::json;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

class RobustnessTest : public ServerTest {
 protected:
  std::string StatusRequest() const { return RequestText("POST", "/api/status", Credentials()); }

  void ExpectThatItStillAnswers() const {
    EXPECT_EQ(ResponseTo("POST", "/api/status", Credentials()).status, 200);
    EXPECT_TRUE(Ask(folder(), {"status", json::object()}).ok);
  }
};

int OpenFiles() {
  int files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    ++files;
  }
  return files;
}

// The server closes a connection a moment after its client.
bool ComesDownTo(int files) {
  for (const auto end = Clock::now() + 10s; Clock::now() < end;) {
    if (OpenFiles() <= files) return true;
    std::this_thread::sleep_for(10ms);
  }
  return false;
}

TEST_F(RobustnessTest, WhatIsNotHttpIsRefused) {
  Start();
  for (const std::string& text :
       {std::string("hello\r\n\r\n"), std::string(300, '\0'), std::string("GET / HTTP/9.9\r\n\r\n"),
        std::string("POST /api/status HTTP/1.1\r\nContent-Length: minus\r\n\r\n"),
        std::string("\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03 GET", 15)}) {
    RawClient client = OnPort();
    client.Send(text);
    EXPECT_EQ(client.Receive().status, 400) << text;
    EXPECT_TRUE(client.IsClosed());
  }
  ExpectThatItStillAnswers();
}

TEST_F(RobustnessTest, LargeBodiesAreRefused) {
  Start();
  RawClient client = OnPort();
  const std::string body(2'000'000, ' ');
  client.Send(RequestText("POST", "/api/status", Credentials(), body));
  EXPECT_EQ(client.Receive().status, 413);
  EXPECT_TRUE(client.IsClosed());
  const RawResponse good =
      ResponseTo("POST", "/api/status", Credentials(), "{" + std::string(1'000'000, ' ') + "}");
  EXPECT_EQ(good.status, 200);
  // Of unknown length, in chunks.
  RawClient chunks = OnPort();
  chunks.Send("POST /api/status HTTP/1.1\r\n" + Credentials() +
              "Transfer-Encoding: chunked\r\n\r\n");
  const std::string chunk = "186a0\r\n" + std::string(100'000, ' ') + "\r\n";
  for (int i = 0; i < 20 && chunks.Send(chunk); ++i) {
  }
  EXPECT_EQ(chunks.Receive().status, 413);
  ExpectThatItStillAnswers();
}

TEST_F(RobustnessTest, LargeHeadersAreRefused) {
  Start();
  RawClient client = OnPort();
  client.Send(RequestText("POST", "/api/status",
                          Credentials() + "X-Long: " + std::string(100'000, 'x') + "\r\n"));
  EXPECT_EQ(client.Receive().status, 431);
  EXPECT_TRUE(client.IsClosed());
  ExpectThatItStillAnswers();
}

TEST_F(RobustnessTest, AClientThatWaitsToBeAskedIsAsked) {
  Start();
  RawClient client = OnPort();
  client.Send("POST /api/status HTTP/1.1\r\n" + Credentials() +
              "Content-Length: 2\r\nExpect: 100-continue\r\n\r\n");
  EXPECT_EQ(client.Receive().status, 100);
  client.Send("{}");
  EXPECT_EQ(client.Receive().status, 200);
}

TEST_F(RobustnessTest, HalfARequestIsWaitedForUntilTheIdleTimeoutEnds) {
  Start({.idle_timeout = 300ms});
  const std::string request = RequestText("POST", "/api/status", Credentials(), "{}");
  for (const size_t length : {size_t{0}, size_t{5}, request.size() - 30, request.size() - 1}) {
    RawClient client = OnPort();
    client.Send(request.substr(0, length));
    const auto begin = Clock::now();
    ExpectThatItStillAnswers();
    EXPECT_TRUE(client.IsClosed());
    EXPECT_GT(Clock::now() - begin, 250ms);
    EXPECT_LT(Clock::now() - begin, 5s);
  }
  EXPECT_EQ(handler_.count(), 8);
}

TEST_F(RobustnessTest, ARequestMayComeInPieces) {
  Start();
  RawClient client = OnPort();
  const std::string request = StatusRequest();
  for (const char byte : request) client.Send({&byte, 1});
  EXPECT_EQ(client.Receive().status, 200);
}

TEST_F(RobustnessTest, AClientThatTakesNoAnswerIsLetGo) {
  ServerLimits limits;
  limits.idle_timeout = 500ms;
  const std::string page(20'000'000, 'x');
  const Server server({.folder = folder(), .limits = limits}, handler_,
                      [&](Page, const std::string&, const std::string&) { return page; });
  RawClient client = OnSocket();
  client.Send(RequestText("GET", "/", ""));
  std::this_thread::sleep_for(100ms);
  EXPECT_TRUE(Ask(folder(), {"status", json::object()}).ok);
  std::this_thread::sleep_for(1s);
  EXPECT_EQ(client.Receive().status, 0);  // it ends before the page does
}

TEST_F(RobustnessTest, RequestsMayComeBeforeTheRepliesAreTaken) {
  Start();
  RawClient client = OnPort();
  std::string requests;
  for (int i = 0; i < 100; ++i) {
    requests +=
        RequestText("POST", "/api/step", Credentials(), fmt::format(R"({{"count":{}}})", i));
  }
  client.Send(requests);
  for (int i = 0; i < 100; ++i) {
    const RawResponse response = client.Receive();
    ASSERT_EQ(response.status, 200) << i;
    EXPECT_EQ(json::parse(response.body)["value"]["arguments"]["count"], i);
  }
}

TEST_F(RobustnessTest, TenThousandRequestsOnOneConnection) {
  Start();
  const int files = OpenFiles();
  {
    RawClient on_port = OnPort();
    RawClient on_socket = OnSocket();
    for (int i = 0; i < 5'000; ++i) {
      for (RawClient* client : {&on_port, &on_socket}) {
        client->Send(StatusRequest());
        ASSERT_EQ(client->Receive().status, 200) << i;
      }
    }
    EXPECT_LE(OpenFiles(), files + 4);
  }
  EXPECT_EQ(handler_.count(), 10'000);
  EXPECT_TRUE(ComesDownTo(files));
}

TEST_F(RobustnessTest, AThousandConnectionsInARow) {
  Start();
  const int files = OpenFiles();
  for (int i = 0; i < 500; ++i) {
    ASSERT_EQ(ResponseTo("POST", "/api/status", Credentials() + "Connection: close\r\n").status,
              200);
    ASSERT_TRUE(Ask(folder(), {"status", json::object()}).ok);
  }
  EXPECT_TRUE(ComesDownTo(files));
}

TEST_F(RobustnessTest, ManyClientsAtOnceGetTheirOwnAnswers) {
  Start();
  std::vector<std::jthread> clients;
  std::atomic<int> right = 0;
  for (int number = 0; number < 8; ++number) {
    clients.emplace_back([this, number, &right] {
      for (int i = 0; i < 100; ++i) {
        const int count = number * 1000 + i;
        const Reply reply = Ask(folder(), {"step", {{"count", count}}});
        if (reply.value["arguments"]["count"] == count) ++right;
      }
    });
  }
  clients.clear();
  EXPECT_EQ(right, 800);
}

TEST_F(RobustnessTest, OnlySoManyClientsAtATime) {
  Start({.connections = 3});
  std::vector<RawClient> clients;
  for (int i = 0; i < 3; ++i) {
    clients.push_back(OnPort());
    clients.back().Send(StatusRequest());
    EXPECT_EQ(clients.back().Receive().status, 200);
  }
  EXPECT_EQ(OnPort().Receive().status, 503);
  EXPECT_TRUE(Ask(folder(), {"status", json::object()}).ok);  // the socket has slots of its own
  clients.pop_back();
  int status = 503;
  for (const auto end = Clock::now() + 10s; status == 503 && Clock::now() < end;) {
    status = ResponseTo("POST", "/api/status", Credentials()).status;
  }
  EXPECT_EQ(status, 200);
}

TEST_F(RobustnessTest, AReplyThatTakesLongHoldsUpNobody) {
  Start({.idle_timeout = 200ms});
  RawClient client = OnPort();
  client.Send(RequestText("POST", "/api/save", Credentials()));
  const ReplyHandler reply = handler_.TakeSave();
  std::this_thread::sleep_for(500ms);  // the idle_timeout is with clients, not with the trainer
  ExpectThatItStillAnswers();
  std::thread([&reply] { reply({.value = "saved"}); }).join();
  EXPECT_EQ(json::parse(client.Receive().body)["value"], "saved");
}

TEST_F(RobustnessTest, AClientMayGoBeforeItsReplyComes) {
  Start();
  std::optional<RawClient> client(OnPort());
  client->Send(RequestText("POST", "/api/save", Credentials()));
  const ReplyHandler reply = handler_.TakeSave();
  client.reset();
  reply({.value = "saved"});
  ExpectThatItStillAnswers();
}

// Requests of which a few bytes are others: each is answered or closed, and nothing else happens.
TEST_F(RobustnessTest, DamagedRequestsAreSurvived) {
  Start();
  std::mt19937 random(1);
  const auto below = [&random](size_t end) { return random() % end; };
  for (int i = 0; i < 3'000; ++i) {
    std::string request =
        i % 2 == 0 ? RequestText("POST", "/api/set", Credentials(),
                                 R"({"name": "task.gain", "from": 1, "to": 2e0, "episodes": 3})")
                   : RequestText("GET", "/api/get?name=task%2Egain", Credentials());
    for (size_t damage = 0; damage <= below(4); ++damage) {
      request[below(request.size())] = static_cast<char>(below(256));
    }
    RawClient client = OnSocket();
    client.Send(request);
    shutdown(client.socket().get(), SHUT_WR);
    ASSERT_TRUE(client.IsClosed()) << request;
  }
  ExpectThatItStillAnswers();
}

// While it lives, this process can open only so many files more.
class FileLimit {
 public:
  explicit FileLimit(int more) {
    getrlimit(RLIMIT_NOFILE, &before_);
    const Descriptor next(dup(STDERR_FILENO));  // the lowest number that is free
    rlimit lower = before_;
    lower.rlim_cur = static_cast<rlim_t>(next.get() + more);
    setrlimit(RLIMIT_NOFILE, &lower);
  }
  FileLimit(const FileLimit&) = delete;
  FileLimit& operator=(const FileLimit&) = delete;
  ~FileLimit() { setrlimit(RLIMIT_NOFILE, &before_); }

 private:
  rlimit before_;
};

TEST_F(RobustnessTest, ClientsWaitWhileThereAreNoMoreDescriptors) {
  Start();
  std::optional<FileLimit> limit(1);
  RawClient client = OnPort();
  ASSERT_TRUE(client.socket().is_open());
  client.Send(StatusRequest());
  std::this_thread::sleep_for(300ms);
  EXPECT_EQ(handler_.count(), 0);
  limit.reset();
  EXPECT_EQ(client.Receive().status, 200);
}

}  // namespace
}  // namespace runtime
