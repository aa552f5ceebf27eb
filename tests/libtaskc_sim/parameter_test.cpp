// Parameters that are set while environments run.
#include <gmock/gmock.h>

#include <string>

#include "tests/libtaskc_sim/opened_sim.h"

namespace libtaskc_sim {
namespace {

using testing::Eq;
using testing::HasSubstr;

constexpr size_t kUpright = 0;  // number of the term that `task.gain` multiplies

taskc_sim_options Swaying(taskc_uint32 count) {
  taskc_sim_options options = OptionsOf(SWAYING, count);
  options.autoreset = TASKC_SIM_SAME_STEP;
  return options;
}

void Set(const OpenedSim& sim, const char* parameter, const char* value,
         const unsigned char* which = nullptr) {
  EXPECT_EQ(taskc_sim_set(sim.get(), which, parameter, value), TASKC_OK) << taskc_sim_error();
}

std::string Refusal(const OpenedSim& sim, const char* parameter, const char* value) {
  EXPECT_EQ(taskc_sim_set(sim.get(), nullptr, parameter, value), TASKC_SIM_ERROR_SETUP);
  return taskc_sim_error();
}

TEST(SimParameters, CountFromTheNextDecisionOn) {
  OpenedSim sim(Swaying(1));
  sim.Reset({1});
  sim.Step();
  const double before = sim.term_sums[kUpright];
  EXPECT_GT(before, 0);
  Set(sim, "task.gain", "0");
  sim.Step();
  EXPECT_EQ(sim.term_sums[kUpright], before);
  Set(sim, "task.gain", "5 1/s");
  sim.Step();
  EXPECT_GT(sim.term_sums[kUpright], before);
}

TEST(SimParameters, PayWhatTheyPayWhereTheyWereSetFromTheStart) {
  static const char* const kSettings[] = {"task.gain=5"};
  taskc_sim_options options = Swaying(1);
  options.settings = kSettings;
  options.setting_count = 1;
  OpenedSim expected(options);
  OpenedSim sim(Swaying(1));
  Set(sim, "task.gain", "5");
  for (OpenedSim* each : {&expected, &sim}) each->Reset({1});
  taskc_uint32 ends = 0;
  for (int i = 0; i < 30; ++i) {  // several episodes
    expected.Step();
    sim.Step();
    EXPECT_EQ(sim.rewards, expected.rewards) << i;
    ends += sim.ended;
  }
  EXPECT_GE(ends, 3U);
}

TEST(SimParameters, AreThoseOfEachEnvironment) {
  OpenedSim sim(Swaying(2));
  const unsigned char second[] = {0, 1};
  Set(sim, "task.gain", "0", second);
  sim.Reset({1, 1});
  sim.Step();
  EXPECT_GT(sim.term_sums[kUpright], 0);
  EXPECT_EQ(sim.term_sums[sim.description().task->term_count + kUpright], 0);
}

TEST(SimParameters, OfAnyModuleWhateverTheirType) {
  OpenedSim sim(Swaying(1));
  Set(sim, "environment.random_friction", "[0.4, 1.2]");
  Set(sim, "environment.start_pose", "sitting");
  sim.Reset({1});
  sim.Step();
}

TEST(SimParameters, AreRefusedWhereTheyDoNotFit) {
  OpenedSim sim(Swaying(2));
  EXPECT_THAT(Refusal(sim, "task.gian", "1"), HasSubstr("did you mean `gain`?"));
  EXPECT_THAT(Refusal(sim, "gain", "1"), HasSubstr("write MODULE.PARAMETER"));
  EXPECT_THAT(Refusal(sim, "task.gain", "6"), Eq("`task.gain` must lie in 0 .. 5, and 6 does not"));
  EXPECT_THAT(Refusal(sim, "task.gain", "2 m"),
              Eq("`task.gain` is a number in 1/s, and `2 m` is not one"));
  EXPECT_THAT(Refusal(sim, "task.gain", "true"), HasSubstr("is a number, and true is not one"));
  EXPECT_THAT(Refusal(sim, "environment.profile", "fast"), HasSubstr("has no effect any more"));
  EXPECT_EQ(taskc_sim_set(sim.get(), nullptr, nullptr, "1"), TASKC_ERROR_NULL);
  EXPECT_EQ(taskc_sim_set(sim.get(), nullptr, "task.gain", nullptr), TASKC_ERROR_NULL);
  sim.Reset({1, 2});
  sim.Step();
  EXPECT_GT(sim.term_sums[kUpright], 0);  // it is still 2
}

}  // namespace
}  // namespace libtaskc_sim
