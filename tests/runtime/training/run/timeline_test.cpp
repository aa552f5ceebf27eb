#include "runtime/training/run/timeline.h"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/runtime/training/run/error_of.h"
#include "tests/runtime/training/run/sample_run.h"

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr size_t kPoses = 9;  // more than a byte has bits

// Of two frames, and of SampleTask().
Timeline SampleTimeline() {
  return {.end = 0.035,
          .returns = {0, 0.5, -4},
          .terms = {{0, 0.5, 0}, {0, 0, -4}},
          .metrics = {{NAN, 0.1f, 0.2f}},
          .phases = {0, 0, 1},
          .contacts = {0, 0, 3, 0, 128, 1}};
}

Recording RecordingOf(const Timeline& timeline) {
  return {2, 0.02, false, "poses", PackTimeline(timeline)};
}

TEST(Timeline, IsReadAsItWasPacked) {
  const Timeline read = ReadTimeline(RecordingOf(SampleTimeline()), SampleTask(), kPoses);
  EXPECT_EQ(read.end, 0.035);
  EXPECT_EQ(read.sample_count(), 3u);
  EXPECT_EQ(read.returns, SampleTimeline().returns);
  EXPECT_EQ(read.terms, SampleTimeline().terms);
  ASSERT_EQ(read.metrics.size(), 1u);
  EXPECT_THAT(read.metrics[0], ElementsAre(testing::NanSensitiveFloatEq(NAN), 0.1f, 0.2f));
  EXPECT_EQ(read.phases, SampleTimeline().phases);
  EXPECT_EQ(read.contacts, SampleTimeline().contacts);
}

TEST(Timeline, HasNoPhasesWhereTheTaskHasNone) {
  Timeline timeline = SampleTimeline();
  timeline.phases.clear();
  TaskRecord task = SampleTask();
  task.phases.clear();
  EXPECT_TRUE(ReadTimeline(RecordingOf(timeline), task, kPoses).phases.empty());
}

TEST(Timeline, IsRefusedWhereItIsDamaged) {
  const auto error_with = [](Recording recording, const TaskRecord& task, size_t links = kPoses) {
    return ErrorOf([&] { ReadTimeline(recording, task, links); });
  };
  TaskRecord other = SampleTask();
  other.terms.pop_back();
  EXPECT_THAT(error_with(RecordingOf(SampleTimeline()), other), HasSubstr("does not fit the task"));
  EXPECT_THAT(error_with(RecordingOf(SampleTimeline()), SampleTask(), 17),
              HasSubstr("does not fit"));
  Recording longer = RecordingOf(SampleTimeline());
  longer.frames = 3;
  EXPECT_THAT(error_with(longer, SampleTask()), HasSubstr("does not fit"));
  Recording cut = RecordingOf(SampleTimeline());
  cut.timeline.resize(cut.timeline.size() / 2);
  EXPECT_THAT(error_with(cut, SampleTask()), HasSubstr("its timeline is damaged"));
  for (const double end : {0.01, double{NAN}, double{INFINITY}}) {
    Timeline timeline = SampleTimeline();
    timeline.end = end;
    EXPECT_THAT(error_with(RecordingOf(timeline), SampleTask()), HasSubstr("ends before"));
  }
}

}  // namespace
}  // namespace runtime
