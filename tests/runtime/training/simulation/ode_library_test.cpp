#include "runtime/training/simulation/ode_library.h"

#include <gtest/gtest.h>

#include <thread>

#include "tests/runtime/training/simulation/robots.h"

namespace runtime {
namespace {

TEST(OdeLibrary, FailsWithAnExceptionInsteadOfAborting) {
  UseOdeInThisThread();
  try {
    dDebug(1, "bad argument %d", 42);
  } catch (const OdeFailure& failure) {
    EXPECT_STREQ(failure.what(), "bad argument 42");
  }
  EXPECT_THROW(dError(1, "worse"), OdeFailure);
}

TEST(OdeLibrary, MessagesAreNotPrinted) {
  UseOdeInThisThread();
  testing::internal::CaptureStderr();
  dMessage(0, "just so you know");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(OdeLibrary, WorldsInSeveralThreadsDoNotDisturbEachOther) {
  const auto final_height = [] {
    World world(Humanoid(), FindProfile("fast"), Humanoid().poses[1]);
    StepFor(world, 0.5, Zeros(Humanoid()));
    return dBodyGetPosition(world.body().body(0))[2];
  };
  const double alone = final_height();
  double results[3];
  std::vector<std::thread> threads;
  for (double& result : results) threads.emplace_back([&] { result = final_height(); });
  for (std::thread& thread : threads) thread.join();
  for (const double result : results) EXPECT_EQ(result, alone);
}

}  // namespace
}  // namespace runtime
