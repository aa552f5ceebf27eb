// What clients hear without having asked.
#include <chrono>

#include "runtime/live/server/event_queue.h"
#include "tests/runtime/live/server/follower.h"
#include "tests/runtime/live/server/server_test.h"

namespace runtime {
namespace {

using nlohmann::json;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

class EventsTest : public ServerTest {
 protected:
  // A client that is accepted, and then takes nothing.
  RawClient Sleeper() const { return OnWebSocket("/api/events"); }
};

TEST(EventQueue, KeepsTheOrder) {
  EventQueue queue(10);
  queue.Push(std::make_shared<std::string>("a"));
  queue.Push(std::make_shared<std::string>("b"));
  EXPECT_EQ(*queue.Pop(), "a");
  EXPECT_EQ(*queue.Pop(), "b");
  EXPECT_EQ(queue.Pop(), nullptr);
}

TEST(EventQueue, SaysHowManyWereMissedAndThenGoesOn) {
  EventQueue queue(2);
  for (const char* name : {"a", "b", "c", "d"}) queue.Push(std::make_shared<std::string>(name));
  EXPECT_EQ(*queue.Pop(), "a");
  queue.Push(std::make_shared<std::string>("e"));  // or it would come before the others are named
  EXPECT_EQ(*queue.Pop(), "b");
  EXPECT_FALSE(queue.empty());
  EXPECT_EQ(*queue.Pop(), R"({"event":"missed","count":3})");
  EXPECT_TRUE(queue.empty());
  queue.Push(std::make_shared<std::string>("f"));
  EXPECT_EQ(*queue.Pop(), "f");
  EXPECT_EQ(queue.Pop(), nullptr);
}

TEST_F(EventsTest, AllClientsHearAllEventsInOrder) {
  Start();
  Follower first(folder());
  Follower second(folder());
  first.WaitUntilItHears(*server_);
  second.WaitUntilItHears(*server_);
  for (int i = 0; i < 100; ++i) server_->Publish({{"event", "episode"}, {"episode", i}});
  server_.reset();
  for (Follower* follower : {&first, &second}) {
    const std::vector<json> events = follower->Wait();
    ASSERT_EQ(events.size(), 100u);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(events[static_cast<size_t>(i)]["episode"], i);
  }
}

TEST_F(EventsTest, WhatNoOneHearsIsNotKept) {
  Start();
  server_->Publish({{"event", "episode"}, {"episode", 1}});
  Follower follower(folder());
  follower.WaitUntilItHears(*server_);
  server_.reset();
  EXPECT_TRUE(follower.Wait().empty());
}

TEST_F(EventsTest, ASlowClientMissesEventsAndHoldsUpNobody) {
  Start({.waiting_events = 100});
  const RawClient sleeper = Sleeper();
  Follower follower(folder());
  follower.WaitUntilItHears(*server_);
  const std::string text(10'000, 'x');
  for (int i = 0; i < 5'000; ++i) {
    const auto begin = Clock::now();
    server_->Publish({{"event", "warning"}, {"text", text}});
    EXPECT_LT(Clock::now() - begin, 1s);
    if (i % 50 == 0) {
      EXPECT_TRUE(Ask(folder(), {"status", json::object()}).ok);
    }
  }
  server_.reset();
  // A client that keeps up may miss some of so many at once, but then it knows how many.
  int64_t heard = 0;
  for (const json& event : follower.Wait()) {
    heard += event["event"] == "missed" ? event["count"].get<int64_t>() : 1;
  }
  EXPECT_GE(heard, 5'000);  // greetings may be among those missed
}

TEST_F(EventsTest, AClientThatHangsIsLetGo) {
  Start({.idle_timeout = 400ms});
  RawClient sleeper = Sleeper();
  const auto begin = Clock::now();
  EXPECT_TRUE(sleeper.IsClosed());  // it answers no ping
  EXPECT_LT(Clock::now() - begin, 5s);
}

TEST_F(EventsTest, AClientThatOnlyListensIsKept) {
  Start({.idle_timeout = 300ms});
  Follower follower(folder());
  follower.WaitUntilItHears(*server_);
  std::this_thread::sleep_for(1s);
  server_->Publish({{"event", "state"}, {"state", "paused"}});
  server_.reset();
  EXPECT_EQ(follower.Wait().size(), 1u);
}

TEST_F(EventsTest, AClientThatSendsTooMuchIsLetGo) {
  Start();
  RawClient client = Sleeper();
  std::string frame = {'\x81', '\xff', 0, 0, 0, 0, 0, 1, 0, 0, 1, 2, 3, 4};  // 65536 bytes, masked
  client.Send(frame + std::string(65536, 'x'));
  EXPECT_TRUE(client.IsClosed());
  EXPECT_TRUE(Ask(folder(), {"status", json::object()}).ok);
}

TEST_F(EventsTest, TheStreamNeedsTheTokenToo) {
  Start();
  EXPECT_EQ(ResponseTo("GET", "/api/events", Host() + kUpgrade).status, 401);
  EXPECT_EQ(ResponseTo("GET", "/api/events?token=" + token_,
                       Host() + kUpgrade + "Origin: http://evil.example\r\n")
                .status,
            403);
  RawClient client = OnPort();
  client.Send(RequestText("GET", "/api/events", Credentials() + kUpgrade));
  EXPECT_EQ(client.Receive().status, 101);
}

}  // namespace
}  // namespace runtime
