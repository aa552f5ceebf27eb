#include "runtime/live/workers/supervisor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace runtime {
namespace {

nlohmann::json Episode(int64_t number, const nlohmann::json& value, const char* end) {
  return {{"episode", number}, {"return", value}, {"end", {{"kind", end}}}, {"wall_seconds", 0.5}};
}

TEST(CountEpisode, KeepsTheLastAndTheBestReturn) {
  RunProgress run{"", "seed1"};
  CountEpisode(Episode(1, 3.5, "truncated"), run);
  CountEpisode(Episode(2, -1.25, "failure"), run);
  EXPECT_EQ(run.episodes, 2);
  EXPECT_EQ(run.episodes_here, 2);
  EXPECT_EQ(run.last_return, -1.25);
  EXPECT_EQ(run.best_return, 3.5);
  EXPECT_EQ(run.wall_seconds, 1);
}

TEST(CountEpisode, ADivergedOneIsNotTheBest) {
  RunProgress run{"", "seed1"};
  CountEpisode(Episode(1, 3.5, "truncated"), run);
  CountEpisode(Episode(2, 287.0, "diverged"), run);
  EXPECT_EQ(run.last_return, 287);
  EXPECT_EQ(run.best_return, 3.5);
  CountEpisode(Episode(3, nullptr, "truncated"), run);
  EXPECT_TRUE(std::isnan(run.last_return));
  EXPECT_EQ(run.best_return, 3.5);
}

}  // namespace
}  // namespace runtime
