#include "runtime/training/run/recorder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "runtime/base/user_error.h"
#include "runtime/training/run/compression.h"

namespace runtime {
namespace {

constexpr int kLinks = 2;
constexpr size_t kFrameSize = kLinks * Recorder::kFloatsPerLink;

// Runs an episode in which every float of a frame is the number of its time step.
void RunEpisode(Recorder& recorder, int time_steps) {
  recorder.StartEpisode();
  for (int step = 0; step <= time_steps; ++step) {
    for (float& value : recorder.NextFrame()) value = static_cast<float>(step);
  }
}

std::vector<float> Floats(const Recording& recording) {
  const std::string bytes = Decompress(recording.poses, "the recording");
  std::vector<float> floats(bytes.size() / sizeof(float));
  std::memcpy(floats.data(), bytes.data(), bytes.size());
  return floats;
}

TEST(Recorder, KeepsAFrameEvery20MillisecondsFromTheStart) {
  Recorder recorder(kLinks, 0.005);
  RunEpisode(recorder, 11);
  const Recording recording = recorder.Finish(true);
  EXPECT_EQ(recording.frames, 3);
  EXPECT_DOUBLE_EQ(recording.frame_interval, 0.02);
  EXPECT_TRUE(recording.is_best);
  const std::vector<float> floats = Floats(recording);
  ASSERT_EQ(floats.size(), 3 * kFrameSize);
  EXPECT_EQ(floats.front(), 0);
  EXPECT_EQ(floats[kFrameSize - 1], 0);
  EXPECT_EQ(floats[kFrameSize], 4);
  EXPECT_EQ(floats.back(), 8);
}

TEST(Recorder, ForgetsTheEpisodeBefore) {
  Recorder recorder(kLinks, 0.005);
  RunEpisode(recorder, 100);
  RunEpisode(recorder, 4);
  EXPECT_EQ(recorder.Finish(false).frames, 2);
}

TEST(Recorder, KeepsEveryStepThatIsLongerThanTheInterval) {
  Recorder recorder(kLinks, 0.05);
  RunEpisode(recorder, 3);
  const Recording recording = recorder.Finish(false);
  EXPECT_EQ(recording.frames, 4);
  EXPECT_DOUBLE_EQ(recording.frame_interval, 0.05);
}

TEST(Recorder, CoversALongEpisodeWithFewerFrames) {
  Recorder recorder(kLinks, 0.02);
  RunEpisode(recorder, 15'000);  // 300 s; the recorder holds 120 s at 20 ms
  const Recording recording = recorder.Finish(false);
  EXPECT_DOUBLE_EQ(recording.frame_interval, 0.08);
  EXPECT_EQ(recording.frames, 3751);
  const std::vector<float> floats = Floats(recording);
  for (size_t frame = 0; frame < 3751; ++frame) {
    ASSERT_EQ(floats[frame * kFrameSize], static_cast<float>(4 * frame));
  }
}

TEST(Compression, RefusesDamagedBlobs) {
  EXPECT_THROW(Decompress("no zstd at all", "the recording"), UserError);
  const std::string text(1000, 'x');
  std::string compressed = Compress(std::as_bytes(std::span(text.data(), text.size())));
  EXPECT_EQ(Decompress(compressed, "the recording"), text);
  compressed.resize(compressed.size() - 2);
  EXPECT_THROW(Decompress(compressed, "the recording"), UserError);
}

}  // namespace
}  // namespace runtime
