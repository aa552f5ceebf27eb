#include "plugins/host/metric_reducer.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace host {
namespace {

using testing::ElementsAre;
using testing::IsNan;

constexpr taskc_metric kMetrics[] = {{"a", "", "", TASKC_LAST},
                                     {"b", "", "", TASKC_SUM},
                                     {"c", "", "", TASKC_MAX},
                                     {"d", "", "", TASKC_MIN},
                                     {"e", "", "", TASKC_MEAN}};

std::vector<double> All(double value) { return std::vector<double>(5, value); }

TEST(MetricReducer, ReducesTheTimeSteps) {
  MetricReducer reducer(kMetrics);
  for (const double value : {3.0, -1.5, 8.0, 0.5}) reducer.EndTimeStep(All(value));
  reducer.EndEpisode(All(7));
  EXPECT_THAT(reducer.values(), ElementsAre(7, 10, 8, -1.5, 2.5));
}

TEST(MetricReducer, StartsEachEpisodeAnew) {
  MetricReducer reducer(kMetrics);
  reducer.EndTimeStep(All(100));
  reducer.EndEpisode(All(100));
  reducer.StartEpisode();
  reducer.EndTimeStep(All(-4));
  reducer.EndTimeStep(All(-6));
  reducer.EndEpisode(All(-6));
  EXPECT_THAT(reducer.values(), ElementsAre(-6, -10, -4, -6, -5));
}

TEST(MetricReducer, EpisodeWithoutATimeStepHasNoLargestSmallestAndMean) {
  MetricReducer reducer(kMetrics);
  reducer.EndEpisode(All(2));
  EXPECT_THAT(reducer.values(), ElementsAre(2, 0, IsNan(), IsNan(), IsNan()));
}

TEST(MetricReducer, OneValueThatIsNotANumberSpoilsTheEpisode) {
  MetricReducer reducer(kMetrics);
  for (const double value : {1.0, std::nan(""), 2.0}) reducer.EndTimeStep(All(value));
  reducer.EndEpisode(All(3));
  EXPECT_THAT(reducer.values(), ElementsAre(3, IsNan(), IsNan(), IsNan(), IsNan()));
}

TEST(MetricReducer, InfinityIsAValue) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  MetricReducer reducer(kMetrics);
  reducer.EndTimeStep(All(-kInfinity));
  reducer.EndEpisode(All(0));
  EXPECT_THAT(reducer.values(), ElementsAre(0, -kInfinity, -kInfinity, -kInfinity, -kInfinity));
}

TEST(MetricReducer, LastNeedsNoTimeSteps) {
  EXPECT_FALSE(MetricReducer(std::span(kMetrics, 1)).needs_time_steps());
  EXPECT_TRUE(MetricReducer(std::span(kMetrics, 2)).needs_time_steps());
  EXPECT_FALSE(MetricReducer({}).needs_time_steps());
}

}  // namespace
}  // namespace host
