// What those who watch get to see.
#include <chrono>
#include <thread>

#include "tests/runtime/live/server/server_test.h"

namespace runtime {
namespace {

using namespace std::chrono_literals;

class ViewTest : public ServerTest {
 protected:
  void WaitForWish(bool instants, bool episode) {
    for (int tries = 0; tries < 5000; ++tries) {
      const ViewWish wish = handler_.wish();
      if (wish.instants == instants && wish.episode == episode) return;
      std::this_thread::sleep_for(1ms);
    }
    FAIL() << "the handler is not told what is wanted";
  }
  void Show(bool is_episode, const std::string& content) {
    server_->Show({.is_episode = is_episode,
                   .layout = layout_,
                   .content = std::make_shared<const std::string>(content)});
  }

  std::shared_ptr<const std::string> layout_ = std::make_shared<const std::string>("layout");
};

TEST_F(ViewTest, NothingIsWantedWhileNobodyWatches) {
  Start();
  {
    RawClient client = OnWebSocket("/api/view");
    WaitForWish(false, false);
    client.SendText("instants");
    WaitForWish(true, false);
    RawClient other = OnWebSocket("/api/view");
    other.SendText("episode");
    WaitForWish(true, true);
    client.SendText("nothing");
    WaitForWish(false, true);
  }
  WaitForWish(false, false);  // they are gone
}

TEST_F(ViewTest, WhatTheNumbersAreComesBeforeTheFirst) {
  Start();
  RawClient client = OnWebSocket("/api/view");
  client.SendText("instants");
  WaitForWish(true, false);
  Show(false, "one");
  EXPECT_EQ(client.ReceiveMessage(), "layout");
  EXPECT_EQ(client.ReceiveMessage(), "one");
  Show(true, "an episode that it did not ask for");
  Show(false, "two");
  EXPECT_EQ(client.ReceiveMessage(), "two");
  layout_ = std::make_shared<const std::string>("another");
  Show(false, "three");
  EXPECT_EQ(client.ReceiveMessage(), "another");
  EXPECT_EQ(client.ReceiveMessage(), "three");
}

TEST_F(ViewTest, AnEpisodeIsShownOnce) {
  Start();
  RawClient client = OnWebSocket("/api/view");
  for (const std::string content : {"one", "another"}) {
    client.SendText("episode");
    WaitForWish(false, true);
    Show(true, content);
    if (content == "one") {
      EXPECT_EQ(client.ReceiveMessage(), "layout");
    }
    EXPECT_EQ(client.ReceiveMessage(), content);
    WaitForWish(false, false);
  }
}

// Of frames that it does not take it gets the last one, and nothing piles up meanwhile.
TEST_F(ViewTest, ASlowClientSeesFewerFrames) {
  Start();
  RawClient client = OnWebSocket("/api/view");
  client.SendText("instants");
  WaitForWish(true, false);
  constexpr int kFrames = 2000;
  const std::string ballast(100'000, 'x');
  for (int i = 0; i < kFrames; ++i) Show(false, std::to_string(i) + ballast);
  EXPECT_EQ(client.ReceiveMessage(), "layout");
  int count = 0;
  for (std::string last; std::atoi(last.c_str()) < kFrames - 1; ++count) {
    last = client.ReceiveMessage();
    ASSERT_NE(last, "");
  }
  EXPECT_LT(count, kFrames / 2);
}

TEST_F(ViewTest, AClientThatSaysTooMuchIsLetGo) {
  Start();
  RawClient client = OnWebSocket("/api/view");
  client.SendText(std::string(100, 'x'));
  EXPECT_TRUE(client.IsClosed());
}

}  // namespace
}  // namespace runtime
