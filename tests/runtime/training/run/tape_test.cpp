#include "runtime/training/run/tape.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "runtime/base/user_error.h"

namespace runtime {
namespace {

Tape SampleTape() {
  Tape tape;
  tape.start_pose = "standing";
  robot::StartState& start = tape.start.emplace();
  start.pose = {"", {0.1, 0.2, 0.3}, {1, 0, 0, 0}, {0.5, -0.5}};
  start.from = {"", {0, 0, 0.3}, {1, 0, 0, 0}, {0, 0}};
  start.joint_velocities = {0.25, -1};
  start.velocity = {1, 2, 3};
  start.angular_velocity = {4, 5, 6};
  tape.discount = 0.9;
  tape.ends_at_once = true;
  tape.joints = 2;
  tape.actions = {1, 0, 2, 0};
  tape.targets = {0.1,    -0.0, std::nextafter(0.1, 1.0),
                  1e-300, 0.1,  std::numeric_limits<double>::infinity()};
  return tape;
}

TEST(Tape, IsPackedBitForBit) {
  const Tape tape = SampleTape();
  const Tape read = Unpack(Pack(tape));
  EXPECT_EQ(read, tape);
  EXPECT_TRUE(std::signbit(read.targets[1]));
  EXPECT_EQ(read.steps(), 3u);
  EXPECT_EQ(read.TargetsOf(1)[1], 1e-300);
}

TEST(Tape, OfAnEpisodeWithoutTimeStepsIsPackedToo) {
  Tape tape = SampleTape();
  tape.actions = {0};
  tape.targets.clear();
  EXPECT_EQ(Unpack(Pack(tape)), tape);
}

// What drives a robot of 17 joints by 5 coordinates for 20 s, 100 KB of numbers for each
// coordinate.
TEST(Tape, TakesLittleRoom) {
  Tape tape = SampleTape();
  constexpr size_t kSteps = 4000;
  tape.joints = 17;
  tape.start.reset();
  tape.actions.assign(kSteps + 1, 0);
  tape.targets.clear();
  for (size_t step = 0; step < kSteps; ++step)
    for (size_t joint = 0; joint < 17; ++joint)
      tape.targets.push_back(
          std::sin(0.01 * static_cast<double>(step) + static_cast<double>(joint % 5)));
  const std::string packed = Pack(tape);
  EXPECT_LT(packed.size(), tape.targets.size() * sizeof(double) / 3);
  EXPECT_EQ(Unpack(packed), tape);
}

TEST(Tape, IsNotReadWhereItIsDamaged) {
  const std::string packed = Pack(SampleTape());
  EXPECT_THROW(Unpack(""), UserError);
  EXPECT_THROW(Unpack(packed.substr(0, packed.size() - 1)), UserError);
  for (size_t i = 0; i < packed.size(); ++i) {
    std::string damaged = packed;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    try {
      Unpack(damaged);  // some bits of the compressed form mean nothing
    } catch (const UserError&) {
    }
  }
}

}  // namespace
}  // namespace runtime
