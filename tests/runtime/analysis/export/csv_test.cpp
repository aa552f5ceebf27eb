#include "runtime/analysis/export/csv.h"

#include <gmock/gmock.h>

#include "tests/runtime/analysis/export/sample_table.h"

namespace runtime {
namespace {

constexpr const char* kNames =
    "episode,end,reason,return,steps,actions,simulated [s],wall [s],cpu [s],faults,violations,"
    "term/speed,term/fall,term/effort,metric/distance [m],log/speed [m/s],log/falls,"
    "goal/place.x [m],goal/place.y [m],phase/reach: time [s],phase/reach: return,"
    "phase/lift: time [s],phase/lift: return,learner/kl\n";

TEST(Csv, HasEveryNumberOfEveryEpisode) {
  const std::string csv = CsvOf({{".", SampleTable()}});
  EXPECT_THAT(csv, testing::StartsWith(kNames));
  EXPECT_THAT(csv, testing::HasSubstr("\n1,truncated,time is over,0.09999999999999999,4001,80,"
                                      "20.005,4.5,4.25,2,3,0.3333333333333333,-4,,0.25,0.125,7,"));
  EXPECT_THAT(csv, testing::HasSubstr(",0.015625\n2,failure,fell,-1.5,4002,80,"));
  EXPECT_THAT(csv, testing::EndsWith(",,,,,\n"));  // what the second has not
}

TEST(Csv, QuotesWhatWouldSplitALine) {
  EpisodeTable table = SampleTable();
  table.episodes[0].active.end_reason = "fell, and \"lay\"";
  EXPECT_THAT(CsvOf({{".", table}}),
              testing::HasSubstr("\n1,truncated,\"fell, and \"\"lay\"\"\",0.0999"));
}

TEST(Csv, OfManyRunsHasTheColumnsOfAll) {
  EpisodeTable other = SampleTable();
  other.columns = {{"return", {1, 2}}, {"term/other", {0.5, 0.25}}};
  const std::string csv = CsvOf({{"a", SampleTable()}, {"b", other}});
  EXPECT_THAT(csv, testing::StartsWith("run,episode,end,reason,return,"));
  EXPECT_THAT(csv, testing::HasSubstr(",learner/kl,term/other\na,1,truncated,"));
  EXPECT_THAT(csv, testing::HasSubstr("\nb,2,failure,fell,2,,,,,,,,,,,,,,,,,,,,,0.25\n"));
}

TEST(Csv, OfNumbersHasThemInEveryDigit) {
  EXPECT_EQ(CsvOf({"time [s]", "turn[0, 1]"}, {{0, 0.1}, {0.04, 1.0 / 3}}),
            "time [s],\"turn[0, 1]\"\n0,0.1\n0.04,0.3333333333333333\n");
}

}  // namespace
}  // namespace runtime
