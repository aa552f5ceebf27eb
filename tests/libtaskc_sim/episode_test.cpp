// Episodes of several environments, one after the other.
#include <gmock/gmock.h>

#include <limits>

#include "tests/libtaskc_sim/opened_sim.h"

namespace libtaskc_sim {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;

// Crawling in decisions of two seconds: episodes of eleven of them, as they end right after 20 s.
taskc_sim_options Coarse(taskc_uint32 count, taskc_int32 autoreset = TASKC_SIM_NEXT_STEP) {
  static const char* const kSettings[] = {"action_space.hold=400"};
  taskc_sim_options options = OptionsOf(CRAWLING, count);
  options.settings = kSettings;
  options.setting_count = 1;
  options.autoreset = autoreset;
  return options;
}

struct Trace {
  std::vector<float> observations;
  std::vector<double> rewards;
  bool operator==(const Trace&) const = default;
};

Trace TraceOf(const taskc_sim_options& options, const std::vector<taskc_uint64>& seeds, int steps) {
  OpenedSim sim(options);
  sim.Reset(seeds);
  Trace trace{sim.observations, {}};
  for (int i = 0; i < steps; ++i) {
    sim.Step();
    trace.observations.insert(trace.observations.end(), sim.observations.begin(),
                              sim.observations.end());
    trace.rewards.insert(trace.rewards.end(), sim.rewards.begin(), sim.rewards.end());
  }
  return trace;
}

TEST(SimEpisodes, AreTheSameForAnyNumberOfThreads) {
  taskc_sim_options options = Coarse(5);
  const std::vector<taskc_uint64> seeds = {3, 1, 4, 1, 5};
  options.threads = 1;
  const Trace alone = TraceOf(options, seeds, 23);
  options.threads = 4;
  EXPECT_EQ(TraceOf(options, seeds, 23), alone);
}

TEST(SimEpisodes, GoOnInStepsOfTheirNumber) {
  OpenedSim sim(Coarse(3, TASKC_SIM_SAME_STEP));
  sim.Reset({});
  std::vector<taskc_int64> numbers;
  for (int i = 0; i < 11; ++i) sim.Step();
  for (const taskc_uint32 i : {0, 1, 2}) numbers.push_back(sim.LastEpisode(i).number);
  EXPECT_THAT(numbers, ElementsAre(1, 2, 3));
  for (int i = 0; i < 11; ++i) sim.Step();
  numbers.clear();
  for (const taskc_uint32 i : {0, 1, 2}) numbers.push_back(sim.LastEpisode(i).number);
  EXPECT_THAT(numbers, ElementsAre(4, 5, 6));
  sim.Reset({10, 20, 30});
  for (int i = 0; i < 11; ++i) sim.Step();
  EXPECT_EQ(sim.LastEpisode(1).number, 21);
}

// Steps until the first environment's episode is over.
void StepToTheEnd(OpenedSim& sim) {
  for (int i = 0; i < 100; ++i) {
    sim.Step();
    if (sim.terminated[0] + sim.truncated[0] > 0) return;
  }
  FAIL() << "no end";
}

TEST(SimEpisodes, TheNextStepBeginsAnotherOne) {
  OpenedSim sim(Coarse(1));
  sim.Reset({7});
  const std::vector<float> first = sim.observations;
  StepToTheEnd(sim);
  EXPECT_THAT(sim.truncated, Each(1));
  EXPECT_EQ(sim.ended, 1U);
  EXPECT_THAT(sim.terminated, Each(0));
  EXPECT_EQ(sim.observations, sim.last_observations);
  EXPECT_NE(sim.observations, first);
  sim.Step();
  EXPECT_EQ(sim.observations, first);  // crawling begins in the same way each time
  EXPECT_THAT(sim.rewards, Each(0.0));
  EXPECT_THAT(sim.truncated, Each(0));
  EXPECT_EQ(sim.ended, 0U);
  EXPECT_THAT(sim.term_sums, Each(0.0));
}

TEST(SimEpisodes, OrTheSameStepDoes) {
  OpenedSim sim(Coarse(1, TASKC_SIM_SAME_STEP));
  sim.Reset({7});
  const std::vector<float> first = sim.observations;
  StepToTheEnd(sim);
  EXPECT_EQ(sim.observations, first);
  EXPECT_NE(sim.last_observations, first);
  const taskc_sim_episode episode = sim.LastEpisode();
  double sum = 0;
  for (size_t i = 0; i < sim.term_sums.size(); ++i) {
    EXPECT_EQ(sim.term_sums[i], episode.terms[i]);
    sum += episode.terms[i];
  }
  EXPECT_NEAR(sum, episode.episode_return, 1e-9);
  EXPECT_EQ(episode.number, 8);
  EXPECT_EQ(episode.kind, TASKC_TRUNCATED);
  EXPECT_EQ(episode.time_steps, 4001);
  EXPECT_EQ(episode.actions, 11);
  EXPECT_DOUBLE_EQ(episode.seconds, 20.005);
}

TEST(SimEpisodes, OrNobodyDoes) {
  OpenedSim sim(Coarse(2, TASKC_SIM_DISABLED));
  sim.Reset({7, 8});
  StepToTheEnd(sim);
  EXPECT_EQ(sim.TryStep(), TASKC_ERROR_WRONG_ORDER);
  EXPECT_THAT(taskc_sim_error(), HasSubstr("environment 0: reset it first"));
  const unsigned char which[] = {1, 0};
  EXPECT_EQ(taskc_sim_reset(sim.get(), which, nullptr, sim.observations.data()), TASKC_OK);
  EXPECT_EQ(sim.TryStep(), TASKC_ERROR_WRONG_ORDER);
  EXPECT_THAT(taskc_sim_error(), HasSubstr("environment 1: reset it first"));
}

TEST(SimEpisodes, EndInColumns) {
  OpenedSim sim(Coarse(3));
  sim.Reset({7, 8, 9});
  sim.Step();
  const unsigned char second[] = {0, 1, 0};  // which begins anew, and so ends later
  ASSERT_EQ(taskc_sim_reset(sim.get(), second, nullptr, nullptr), TASKC_OK);
  StepToTheEnd(sim);
  const taskc_plugin& task = *sim.description().task;
  std::vector<taskc_int64> numbers(3, 99);
  std::vector<taskc_int32> kinds(3, 99);
  std::vector<const char*> reasons(3, "");
  std::vector<double> returns(3, 99);
  std::vector<double> terms(size_t{task.term_count} * 3, 99);
  std::vector<double> metrics(size_t{task.metric_count} * 3, 99);
  const taskc_sim_ends ends = {numbers.data(), kinds.data(), reasons.data(), returns.data(),
                               nullptr,        terms.data(), metrics.data(), nullptr};
  ASSERT_EQ(taskc_sim_last_ends(sim.get(), &ends), TASKC_OK) << taskc_sim_error();
  EXPECT_THAT(numbers, ElementsAre(8, 0, 10));
  EXPECT_THAT(kinds, ElementsAre(TASKC_TRUNCATED, -1, TASKC_TRUNCATED));
  EXPECT_EQ(reasons[1], nullptr);
  for (const size_t i : {0, 2}) {
    const taskc_sim_episode episode = sim.LastEpisode(static_cast<taskc_uint32>(i));
    EXPECT_STREQ(reasons[i], episode.reason);
    EXPECT_EQ(returns[i], episode.episode_return);
    for (size_t k = 0; k < task.term_count; ++k) EXPECT_EQ(terms[3 * k + i], episode.terms[k]);
    EXPECT_EQ(metrics[i], episode.metrics[0]);
  }
  EXPECT_EQ(returns[1], 0);
  EXPECT_EQ(terms[1], 0);
  EXPECT_EQ(metrics[1], 0);
  EXPECT_EQ(taskc_sim_last_ends(sim.get(), nullptr), TASKC_ERROR_NULL);
}

TEST(SimEpisodes, AreGivenUpByAReset) {
  OpenedSim sim(Coarse(1));
  sim.Reset({7});
  const std::vector<float> first = sim.observations;
  sim.Step();
  const std::vector<double> paid = sim.rewards;
  sim.Step();
  sim.Reset({7});
  EXPECT_EQ(sim.observations, first);
  sim.Step();
  EXPECT_EQ(sim.rewards, paid);
}

TEST(SimEpisodes, AnActionIsFinite) {
  OpenedSim sim(Coarse(2));
  sim.Reset({1, 2});
  sim.actions.back() = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(sim.TryStep(), TASKC_ERROR_OUT_OF_RANGE);
  EXPECT_THAT(taskc_sim_error(), HasSubstr("of the action of environment 1 is nan"));
}

}  // namespace
}  // namespace libtaskc_sim
