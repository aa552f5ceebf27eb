#include <gmock/gmock.h>
#include <taskc/host.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "tests/libtaskc/opened_task.h"

namespace libtaskc {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// One recorded episode of the task `each`: float32 places with an unused column in between.
class Record {
 public:
  explicit Record(std::vector<double> x) : x_(std::move(x)), places_(x_.size()), turns_(x_.size()) {
    for (size_t i = 0; i < x_.size(); ++i) places_[i] = {static_cast<float>(x_[i]), 0, 0.25F, -1};
    columns_ = {
        {.sensor = "place",
         .unit = "m",
         .view = {.data = places_.data(), .format = TASKC_FLOAT32},
         .time_stride = sizeof places_[0]},
        {.sensor = "turn", .view = {.data = turns_.data()}, .time_stride = sizeof turns_[0]},
        {.sensor = "steps", .view = {.data = &steps_, .format = TASKC_INT64}},
        {.sensor = "touches[0]", .view = {.data = &touch_, .format = TASKC_BOOL8}},
        {.sensor = "touches[1]", .view = {.data = &touch_, .format = TASKC_BOOL8}},
        {.sensor = "touches[2]", .view = {.data = &touch_, .format = TASKC_BOOL8}}};
    recording.columns = columns_.data();
    recording.column_count = static_cast<taskc_uint32>(columns_.size());
    recording.rows = static_cast<taskc_int64>(x_.size());
    recording.time_step = 0.5;
    recording.seed = 1;
    rewards.resize(x_.size(), NAN);
    recording.rewards = rewards.data();
  }
  Record(const Record&) = delete;
  Record& operator=(const Record&) = delete;

  taskc_recording recording{};
  std::vector<double> rewards;

 private:
  std::vector<double> x_;
  std::vector<std::array<float, 4>> places_;
  std::vector<std::array<double, 4>> turns_;
  taskc_int64 steps_ = 0;
  unsigned char touch_ = 0;
  std::vector<taskc_column> columns_;
};

class EvaluateTest : public testing::Test {
 protected:
  taskc_evaluation Evaluate(const Record& record) {
    taskc_evaluation evaluation{};
    EXPECT_EQ(taskc_evaluate(instance_, &record.recording, 1, 1, &evaluation), TASKC_OK)
        << taskc_error();
    return evaluation;
  }

  OpenedTask task_{"each"};
  Instance instance_{task_};
};

TEST_F(EvaluateTest, PaysWhatTheEventsWouldPay) {
  Record record({1, 2, 3, 4});
  record.recording.action_length = 2;
  std::vector<double> sums(16);
  record.recording.term_sums = sums.data();
  std::vector<double> terms(4);
  std::vector<double> metrics(2);
  std::vector<double> logs(1);
  taskc_evaluation evaluation{
      .terms = terms.data(), .metrics = metrics.data(), .logs = logs.data()};
  ASSERT_EQ(taskc_evaluate(instance_, &record.recording, 1, 1, &evaluation), TASKC_OK);
  // Each action begins with 0.5 and is done with 0.75.
  EXPECT_THAT(record.rewards, ElementsAre(1.5, 2.75, 3.5, 4.75));
  EXPECT_EQ(evaluation.episode_return, 12.5);
  EXPECT_EQ(evaluation.time_steps, 4);
  EXPECT_EQ(evaluation.kind, TASKC_TRUNCATED);
  EXPECT_EQ(evaluation.end, -1);
  EXPECT_THAT(terms, ElementsAre(1, 10, 0, 1.5));
  EXPECT_EQ(metrics[0], 0.25);
  EXPECT_THAT(logs, ElementsAre(10));
  EXPECT_EQ(sums[1], 1);
  EXPECT_EQ(sums[4 + 1], 3);
  EXPECT_EQ(sums[12 + 1], 10);
}

TEST_F(EvaluateTest, StopsWhereTheTaskEndsTheEpisode) {
  Record record({1, 6, 1, 1});
  const taskc_evaluation evaluation = Evaluate(record);
  EXPECT_EQ(evaluation.kind, TASKC_SUCCESS);
  EXPECT_EQ(evaluation.end, 0);
  EXPECT_EQ(evaluation.time_steps, 2);
  EXPECT_THAT(record.rewards, ElementsAre(1.5, 6, 0, 0)) << "the action is not done";
}

TEST_F(EvaluateTest, OrWithTheActionInWhichItDoes) {
  Record record({6, 1, 1, 1});
  const unsigned char new_actions[] = {1, 0, 0, 1};
  record.recording.new_actions = new_actions;
  record.recording.ends_with_action = 1;
  EXPECT_EQ(Evaluate(record).time_steps, 3);
}

TEST_F(EvaluateTest, AnActionMayBeLongerThanAnyRecording) {
  Record record({1, 2});
  record.recording.begins_with_start = 1;
  record.recording.action_length = std::numeric_limits<taskc_int64>::max();
  Evaluate(record);
  EXPECT_THAT(record.rewards, ElementsAre(0, 3.25));
}

TEST_F(EvaluateTest, TheFirstRowMayBeTheStart) {
  Record record({8, 2, 3});
  record.recording.begins_with_start = 1;
  const taskc_evaluation evaluation = Evaluate(record);
  EXPECT_EQ(evaluation.time_steps, 2);
  EXPECT_THAT(record.rewards, ElementsAre(0, 2.5, 3.75));
}

TEST_F(EvaluateTest, TakesTheParamsAndGoalsOfTheInstance) {
  const double held[] = {1, 0};
  ASSERT_EQ(taskc_hold_goal(instance_, "target", "m", held), TASKC_OK);
  ASSERT_EQ(taskc_set_param(instance_, "gain", "", 0), TASKC_OK);
  const Record record({1, 4});
  double metrics[2];
  taskc_evaluation evaluation{.metrics = metrics};
  ASSERT_EQ(taskc_evaluate(instance_, &record.recording, 1, 1, &evaluation), TASKC_OK);
  EXPECT_EQ(evaluation.episode_return, 1.25);
  EXPECT_EQ(metrics[1], 3) << "the distance of the last place to the target";
}

TEST_F(EvaluateTest, ThreadsChangeNothing) {
  std::vector<std::unique_ptr<Record>> records;
  std::vector<taskc_recording> recordings;
  for (int i = 0; i < 20; ++i) {
    records.push_back(std::make_unique<Record>(std::vector<double>(100 + i, 0.01 * i)));
    recordings.push_back(records.back()->recording);
  }
  std::vector<taskc_evaluation> one(20);
  std::vector<taskc_evaluation> many(20);
  ASSERT_EQ(taskc_evaluate(instance_, recordings.data(), 20, 1, one.data()), TASKC_OK);
  ASSERT_EQ(taskc_evaluate(instance_, recordings.data(), 20, 7, many.data()), TASKC_OK);
  for (size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(one[i].episode_return, many[i].episode_return);
    EXPECT_EQ(one[i].time_steps, 100 + static_cast<taskc_int64>(i));
  }
}

// A task that does nothing between the ends of time steps is evaluated by a shorter way.
TEST(EvaluateCrawling, PaysTheSameByTheShortWay) {
  const OpenedTask task("crawling");
  const Instance instance(task);
  constexpr taskc_int64 kRows = 50;
  std::vector<std::vector<double>> numbers;
  std::vector<taskc_column> columns;
  for (taskc_uint32 i = 0; i < task.table().sensor_count; ++i) {
    const taskc_sensor& sensor = task.table().sensors[i];
    const size_t size = size_t{sensor.rows} * sensor.columns;
    std::vector<double>& column = numbers.emplace_back(size * kRows);
    for (size_t k = 0; k < column.size(); ++k)
      column[k] = static_cast<double>((k + i) % 11) / 9 - 0.5;
    if (sensor.scalar == TASKC_BOOL) column.back() = 0;
    columns.push_back({.sensor = sensor.name,
                       .view = {.data = column.data()},
                       .time_stride = static_cast<ptrdiff_t>(size * sizeof(double))});
  }
  numbers[0][40] = 21;  // the time, which is up
  unsigned char new_actions[kRows] = {};
  for (taskc_int64 row = 0; row < kRows; row += 7) new_actions[row] = 1;
  std::vector<std::vector<double>> rewards;
  for (const unsigned char* actions : {static_cast<unsigned char*>(nullptr), +new_actions}) {
    std::vector<double>& paid = rewards.emplace_back(kRows);
    const taskc_recording recording{.columns = columns.data(),
                                    .column_count = static_cast<taskc_uint32>(columns.size()),
                                    .rows = kRows,
                                    .time_step = 0.005,
                                    .action_length = 7,
                                    .new_actions = actions,
                                    .rewards = paid.data()};
    taskc_evaluation evaluation{};
    ASSERT_EQ(taskc_evaluate(instance, &recording, 1, 1, &evaluation), TASKC_OK) << taskc_error();
    EXPECT_EQ(evaluation.time_steps, 41);
    EXPECT_STREQ(task.table().ends[evaluation.end].reason, "time is up");
  }
  EXPECT_EQ(rewards[0], rewards[1]);
  EXPECT_NE(rewards[0][40], 0);
  EXPECT_EQ(rewards[0][41], 0);
}

TEST_F(EvaluateTest, MistakesAreSaidBeforeAnythingIsWritten) {
  Record good({1, 2});
  Record bad({1, 2});
  bad.recording.rows = 0;
  const taskc_recording recordings[] = {good.recording, bad.recording};
  taskc_evaluation evaluations[2] = {};
  EXPECT_EQ(taskc_evaluate(instance_, recordings, 2, 1, evaluations), TASKC_ERROR_OUT_OF_RANGE);
  EXPECT_STREQ(taskc_error(), "recording 1: a recording cannot have 0 rows");
  EXPECT_TRUE(std::isnan(good.rewards[0]));
  good.recording.column_count = 1;
  EXPECT_EQ(taskc_evaluate(instance_, &good.recording, 1, 1, evaluations), TASKC_ERROR_NOT_BOUND);
  EXPECT_THAT(taskc_error(), HasSubstr("`steps`, `touches`"));
  EXPECT_EQ(taskc_evaluate(instance_, nullptr, 0, 1, nullptr), TASKC_OK);
}

}  // namespace
}  // namespace libtaskc
