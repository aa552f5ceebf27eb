#include "runtime/base/in_parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace runtime {
namespace {

TEST(InParallel, DoesEachOnce) {
  std::vector<std::atomic<int>> times(1000);
  InParallel(times.size(), [&](size_t i) { ++times[i]; });
  for (const std::atomic<int>& each : times) EXPECT_EQ(each, 1);
  InParallel(0, [](size_t) { FAIL(); });
}

TEST(InParallel, ThrowsTheFirstFailureWhenAllAreDone) {
  std::atomic<int> done = 0;
  const auto work = [&](size_t i) {
    ++done;
    if (i == 30 || i == 7) throw std::runtime_error(std::to_string(i));
  };
  try {
    InParallel(100, work);
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "7");
  }
  EXPECT_EQ(done, 100);
}

}  // namespace
}  // namespace runtime
