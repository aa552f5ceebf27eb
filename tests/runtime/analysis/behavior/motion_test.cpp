#include "runtime/analysis/behavior/motion.h"

#include <gtest/gtest.h>

#include <limits>

#include "runtime/base/user_error.h"
#include "runtime/training/run/compression.h"

namespace runtime {
namespace {

Recording RecordingOf(const std::vector<float>& poses, int64_t frames) {
  return {frames, 0.02, false, Compress(std::as_bytes(std::span(poses)))};
}

// Two frames of two links; the second link's quaternion is twice as long as it should be.
std::vector<float> SamplePoses() {
  return {1, 2, 3, 1, 0, 0, 0, 4, 5, 6, 0, 2, 0, 0, 7, 8, 9, 1, 0, 0, 0, 10, 11, 12, 0, 0, 2, 0};
}

TEST(ReadMotion, GivesEachLinkItsPoses) {
  const Motion motion = ReadMotion(RecordingOf(SamplePoses(), 2), 2);
  EXPECT_EQ(motion.frame_count(), 2);
  EXPECT_DOUBLE_EQ(motion.duration(), 0.02);
  EXPECT_EQ(motion.position(0, 1), Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(motion.position(1, 0), Eigen::Vector3d(7, 8, 9));
  EXPECT_EQ(motion.orientation(1, 1).coeffs(), Eigen::Vector4d(0, 1, 0, 0));  // x y z w
}

TEST(ReadMotion, EndsWhereTheSimulationDiverged) {
  std::vector<float> poses = SamplePoses();
  poses[20] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(ReadMotion(RecordingOf(poses, 2), 2).frame_count(), 1);
}

TEST(ReadMotion, RefusesWhatDoesNotFit) {
  EXPECT_THROW(ReadMotion(RecordingOf(SamplePoses(), 2), 3), UserError);
  EXPECT_THROW(ReadMotion(RecordingOf(SamplePoses(), 3), 2), UserError);
  EXPECT_THROW(ReadMotion(RecordingOf({}, 0), 2), UserError);
}

}  // namespace
}  // namespace runtime
