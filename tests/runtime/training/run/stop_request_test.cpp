#include "runtime/training/run/stop_request.h"

#include <gtest/gtest.h>

#include <csignal>

namespace runtime {
namespace {

TEST(StopRequest, NotesTheFirstSignal) {
  StopRequest request;
  EXPECT_EQ(request.signal(), 0);
  std::raise(SIGTERM);
  EXPECT_EQ(request.signal(), SIGTERM);
}

TEST(StopRequest, StartsAnew) {
  {
    const StopRequest request;
    std::raise(SIGINT);
  }
  EXPECT_EQ(StopRequest().signal(), 0);
}

TEST(StopRequest, NotesTheSecondWhereThatIsWanted) {
  const StopRequest request(StopRequest::Second::kIsNoted);
  EXPECT_FALSE(request.is_urgent());
  std::raise(SIGINT);
  EXPECT_FALSE(request.is_urgent());
  std::raise(SIGTERM);
  EXPECT_TRUE(request.is_urgent());
  EXPECT_EQ(request.signal(), SIGTERM);
}

TEST(StopRequestDeathTest, LetsTheThirdSignalEndTheProcessInAnyCase) {
  EXPECT_EXIT(
      {
        StopRequest request(StopRequest::Second::kIsNoted);
        for (int i = 0; i < 3; ++i) std::raise(SIGINT);
      },
      testing::KilledBySignal(SIGINT), "");
}

TEST(StopRequestDeathTest, LetsTheSecondSignalEndTheProcess) {
  EXPECT_EXIT(
      {
        StopRequest request;
        std::raise(SIGINT);
        std::raise(SIGINT);
      },
      testing::KilledBySignal(SIGINT), "");
}

}  // namespace
}  // namespace runtime
