#include "runtime/live/control/request_queue.h"

#include <gmock/gmock.h>

#include <map>
#include <thread>
#include <utility>

namespace runtime {
namespace {

using std::chrono::milliseconds;
using testing::IsEmpty;
using testing::SizeIs;

QueuedRequest Numbered(
    int sender, int number, ReplyHandler reply = [](Reply) {}) {
  return {&FindCommand("status"), {{"sender", sender}, {"number", number}}, std::move(reply), {}};
}

TEST(RequestQueue, KeepsTheOrder) {
  RequestQueue queue;
  EXPECT_FALSE(queue.has_requests());
  for (int i = 0; i < 3; ++i) queue.Push(Numbered(0, i));
  EXPECT_TRUE(queue.has_requests());
  const std::vector<QueuedRequest> taken = queue.TakeAll();
  ASSERT_THAT(taken, SizeIs(3));
  for (int i = 0; i < 3; ++i) EXPECT_EQ(taken[i].arguments["number"], i);
  EXPECT_FALSE(queue.has_requests());
  EXPECT_THAT(queue.TakeAll(), IsEmpty());
}

TEST(RequestQueue, CloseRefusesWhatWaitsAndWhatComes) {
  RequestQueue queue;
  std::vector<std::string> errors;
  const auto note = [&](Reply reply) {
    EXPECT_FALSE(reply.ok);
    errors.push_back(reply.error);
  };
  queue.Push(Numbered(0, 0, note));
  EXPECT_THAT(errors, IsEmpty());
  queue.Close();
  EXPECT_THAT(errors, SizeIs(1));
  queue.Push(Numbered(0, 1, note));
  EXPECT_THAT(errors, testing::ElementsAre("the trainer has ended", "the trainer has ended"));
  EXPECT_FALSE(queue.has_requests());
  queue.Close();
  EXPECT_THAT(errors, SizeIs(2));
}

TEST(RequestQueue, WaitsUntilThereIsARequest) {
  RequestQueue queue;
  queue.WaitFor(milliseconds(1));
  std::thread sender([&] {
    std::this_thread::sleep_for(milliseconds(20));
    queue.Push(Numbered(0, 0));
  });
  queue.WaitFor(milliseconds(60'000));
  EXPECT_THAT(queue.TakeAll(), SizeIs(1));
  sender.join();
}

// Every request is taken or refused, once, and those of one sender in their order.
TEST(RequestQueue, SeveralThreadsMaySend) {
  constexpr int kSenders = 4;
  constexpr int kEach = 2000;
  RequestQueue queue;
  std::atomic<int> refused = 0;
  std::vector<std::thread> senders;
  for (int sender = 0; sender < kSenders; ++sender) {
    senders.emplace_back([&, sender] {
      for (int i = 0; i < kEach; ++i) {
        queue.Push(Numbered(sender, i, [&](Reply) { ++refused; }));
      }
    });
  }
  int taken = 0;
  std::map<int, int> next;
  while (taken < kSenders * kEach / 2) {
    queue.WaitFor(milliseconds(100));
    for (const QueuedRequest& each : queue.TakeAll()) {
      ++taken;
      EXPECT_EQ(each.arguments["number"], next[each.arguments["sender"]]++);
    }
  }
  queue.Close();
  for (std::thread& sender : senders) sender.join();
  EXPECT_EQ(taken + refused, kSenders * kEach);
}

}  // namespace
}  // namespace runtime
