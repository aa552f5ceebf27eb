// Our own code allocates nothing while an episode runs.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "runtime/training/simulation/robot_environment.h"
#include "tests/runtime/training/simulation/robots.h"

namespace {

bool counting = false;
int allocations = 0;

void* Allocate(std::size_t size) {
  if (counting) ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return Allocate(size); }
void* operator new[](std::size_t size) { return Allocate(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace runtime {
namespace {

class RobotEnvironmentTest : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(, RobotEnvironmentTest, testing::Values("paper", "fast-tree"),
                         ProfileInName);

TEST_P(RobotEnvironmentTest, AllocatesNothingWhileAnEpisodeRuns) {
  RobotEnvironment environment("environment", Context{&Humanoid(), {}, 0});
  environment.Set("profile", std::string(GetParam()));
  environment.Start();
  environment.StartEpisode();
  environment.RunTimeStep();
  std::vector<float> pose(7 * environment.pose_count());
  allocations = 0;
  counting = true;
  for (int step = 0; step < 40; ++step) {
    environment.RunTimeStep();
    for (const robot::SensorDescription& sensor : robot::Sensors()) {
      for (Port* port : environment.ports()) {
        if (port->name() == sensor.name) (*static_cast<SensorOut*>(port))();
      }
    }
    environment.CapturePose(pose);
  }
  counting = false;
  EXPECT_EQ(allocations, 0);
}

TEST(RobotEnvironment, AllocationsAreCounted) {
  allocations = 0;
  counting = true;
  const std::vector<int> vector(3);
  counting = false;
  EXPECT_EQ(allocations, 1);
}

}  // namespace
}  // namespace runtime
