#include "runtime/training/learning/peng_q_lambda.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runtime/training/learning/fake_world.h"
#include "tests/runtime/training/learning/user_error_of.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

// One action and one feature that is 1: theta is the value of the only state.
class PengQLambdaTest : public testing::Test {
 protected:
  PengQLambdaTest() {
    world_.ConnectTo(learner_);
    learner_.Start();
  }
  void UseImmediateEnds() { learner_.Set("episode_end", std::string("immediate")); }
  double theta() const { return learner_.q_lambda().theta()(0, 0); }

  FakeWorld world_{1, 1};
  PengQLambda learner_{"learner", HumanoidContext()};
};

TEST_F(PengQLambdaTest, EpisodeStartsWithAnAction) {
  EXPECT_TRUE(learner_.episode_over());
  world_.start_of_episode();
  EXPECT_FALSE(learner_.episode_over());
  EXPECT_THAT(world_.told, ElementsAre("start_of_action", "execute"));
}

TEST_F(PengQLambdaTest, EachActionIsFollowedByAnother) {
  world_.start_of_episode();
  world_.PlayAction(0);
  world_.PlayAction(0);
  EXPECT_THAT(world_.told, ElementsAre("start_of_action", "execute", "start_of_action", "execute",
                                       "start_of_action", "execute"));
  EXPECT_EQ(learner_.action_count(), 3);
}

// alpha = 0.3, V = 0: theta = 0.3 * (1 + 0.5), the sum of what was paid during the action.
TEST_F(PengQLambdaTest, LearnsFromTheSumOfAnActionsRewards) {
  world_.start_of_episode();
  world_.reward(1);
  world_.reward(0.5);
  world_.end_of_action();
  EXPECT_NEAR(theta(), 0.45, 1e-15);
}

// The first action brought nothing and left a trace of 0.81; the second one's 10 give
// theta = 0.3 * 10 * (0.81 + 1).
TEST_F(PengQLambdaTest, RewardsAtTheStartOfAnActionBelongToIt) {
  world_.start_of_episode();
  world_.at_start_of_action = [this] { world_.reward(10); };
  world_.PlayAction(0);
  EXPECT_EQ(theta(), 0);
  world_.at_start_of_action = [] {};
  world_.PlayAction(0);
  EXPECT_NEAR(theta(), 5.43, 1e-14);
}

TEST_F(PengQLambdaTest, ReturnIsTheSumOfAllRewards) {
  world_.start_of_episode();
  world_.PlayAction(1);
  world_.PlayAction(2);
  world_.reward(4);
  EXPECT_EQ(learner_.episode_return(), 7);  // also of the action that runs
  world_.end_of_episode(kGoal);
  world_.end_of_action();
  EXPECT_EQ(learner_.episode_return(), 7);
  world_.reward(100);  // of no episode
  EXPECT_EQ(learner_.episode_return(), 7);
  world_.start_of_episode();
  EXPECT_EQ(learner_.episode_return(), 0);
}

// First episode: theta = 0.3 * 1.5 = 0.45. Second, with alpha = 0.3 exp(-0.002): the end's own
// value counts, so theta = 0.45 + alpha (1.5 + 0.9 * 0.45 - 0.45) = 0.8856283.
TEST_F(PengQLambdaTest, OriginalEndsWithTheActionAndBootstraps) {
  for (int episode = 0; episode < 2; ++episode) {
    world_.start_of_episode();
    world_.told.clear();
    world_.reward(1);
    world_.end_of_episode(kGoal);
    EXPECT_FALSE(learner_.episode_over());
    world_.reward(0.5);
    world_.end_of_action();
    EXPECT_TRUE(learner_.episode_over());
    EXPECT_THAT(world_.told, ElementsAre("episode_over: goal"));
  }
  EXPECT_NEAR(theta(), 0.45 + 0.29940059960019994 * 1.455, 1e-14);
  EXPECT_EQ(learner_.episode_return(), 1.5);
}

// theta = 0.3, then 0.3 + alpha (1 - 0.3): nothing is worth anything after a terminal end.
TEST_F(PengQLambdaTest, ImmediateEndsAtOnceAndDoesNotBootstrap) {
  UseImmediateEnds();
  for (const EpisodeEnd& end : {kGoal, kFall}) {
    world_.start_of_episode();
    world_.reward(1);
    world_.end_of_episode(end);
    EXPECT_TRUE(learner_.episode_over());
    world_.reward(0.5);
    world_.end_of_action();  // the action space has not heard of the end
    EXPECT_EQ(learner_.episode_return(), 1);
  }
  EXPECT_NEAR(theta(), 0.3 + 0.29940059960019994 * 0.7, 1e-14);
}

// theta = 0.3, then 0.3 + alpha (1 + 0.9 * 0.3 - 0.3).
TEST_F(PengQLambdaTest, CleanBootstrapsFromATruncatedEpisode) {
  UseImmediateEnds();
  for (int episode = 0; episode < 2; ++episode) {
    world_.start_of_episode();
    world_.reward(1);
    world_.end_of_episode(kTimeIsUp);
    EXPECT_TRUE(learner_.episode_over());
  }
  EXPECT_NEAR(theta(), 0.3 + 0.29940059960019994 * 0.97, 1e-14);
}

TEST_F(PengQLambdaTest, DivergenceEndsAtOnceAndThrowsTheActionAway) {
  for (const char* mode : {"after_action", "immediate"}) {
    learner_.Set("episode_end", std::string(mode));
    world_.start_of_episode();
    world_.PlayAction(1);
    const double before = theta();
    world_.reward(1e6);
    world_.end_of_episode(kBlownUp);
    EXPECT_TRUE(learner_.episode_over());
    EXPECT_EQ(theta(), before);
    EXPECT_EQ(learner_.episode_end().kind, EndKind::kDiverged);
  }
  EXPECT_EQ(learner_.episode_count(), 2);
}

TEST_F(PengQLambdaTest, DivergenceOverridesAnEndThatWaitsForItsAction) {
  world_.start_of_episode();
  world_.end_of_episode(kTimeIsUp);
  world_.end_of_episode(kBlownUp);
  EXPECT_TRUE(learner_.episode_over());
  EXPECT_EQ(learner_.episode_end().kind, EndKind::kDiverged);
}

TEST_F(PengQLambdaTest, TheFirstEndCounts) {
  world_.start_of_episode();
  world_.end_of_episode(kFall);
  world_.end_of_episode(kGoal);
  world_.end_of_action();
  EXPECT_STREQ(learner_.episode_end().reason, "fall");
}

// Its task may be gone before the episode is over.
TEST_F(PengQLambdaTest, TheReasonOfAnEndOutlivesItsTask) {
  std::string reason = "a reason that is too long to be kept in the string itself";
  const std::string said = reason;
  world_.start_of_episode();
  world_.end_of_episode({EndKind::kFailure, reason.c_str()});
  reason.assign(reason.size(), '?');
  world_.end_of_action();
  EXPECT_EQ(learner_.episode_end().reason, said);
  EXPECT_EQ(world_.told.back(), "episode_over: " + said);
}

// Without traces the second action's 10 are not credited to the first: theta = 0.3 * 10.
TEST_F(PengQLambdaTest, ActionsBeforeTheTracesAreClearedGetNoCredit) {
  world_.start_of_episode();
  world_.PlayAction(0);
  learner_.ForgetCredit();
  EXPECT_FALSE(learner_.episode_over());
  world_.PlayAction(10);
  EXPECT_NEAR(theta(), 3, 1e-14);
}

TEST_F(PengQLambdaTest, ForgetsInTheMiddleOfAnEpisodeAndGoesOn) {
  const double first_rate = learner_.learning_rate();
  for (int episode = 0; episode < 3; ++episode) {
    world_.start_of_episode();
    world_.end_of_episode(kGoal);
    world_.PlayAction(1);
  }
  world_.start_of_episode();
  world_.PlayAction(1);
  EXPECT_LT(learner_.learning_rate(), first_rate);
  EXPECT_NE(theta(), 0);
  learner_.Forget();
  EXPECT_EQ(theta(), 0);
  EXPECT_TRUE(learner_.q_lambda().traces().isZero(0));
  EXPECT_EQ(learner_.learning_rate(), first_rate);
  EXPECT_FALSE(learner_.episode_over());
  world_.PlayAction(1);
  EXPECT_NE(theta(), 0);
}

TEST(PengQLambda, WhatTheEndOfTheEpisodeBringsBelongsToTheLastAction) {
  for (const char* mode : {"after_action", "immediate"}) {
    PengQLambda learner("learner", HumanoidContext());
    FakeWorld world(1, 1);
    world.ConnectTo(learner);
    learner.Set("episode_end", std::string(mode));
    world.at_episode_over = [&world] {
      world.reward(2);
      world.end_of_episode(kFall);  // too late
    };
    world.start_of_episode();
    world.reward(1);
    world.end_of_episode(kGoal);
    world.end_of_action();
    EXPECT_NEAR(learner.q_lambda().theta()(0, 0), 0.9, 1e-15) << mode;
    EXPECT_EQ(learner.episode_return(), 3) << mode;
    EXPECT_EQ(learner.episode_end().kind, EndKind::kSuccess) << mode;
    EXPECT_EQ(learner.episode_count(), 1) << mode;
  }
}

TEST_F(PengQLambdaTest, ATaskCanEndTheEpisodeAtTheStartOfAnAction) {
  UseImmediateEnds();
  world_.start_of_episode();
  world_.at_start_of_action = [this] { world_.end_of_episode(kFall); };
  world_.told.clear();
  world_.PlayAction(1);
  EXPECT_TRUE(learner_.episode_over());
  EXPECT_THAT(world_.told, ElementsAre("start_of_action", "episode_over: fall"));  // no execute
}

TEST_F(PengQLambdaTest, ATaskCanEndTheEpisodeAtItsStart) {
  world_.end_of_episode(kFall);
  world_.start_of_episode();
  EXPECT_FALSE(learner_.episode_over());
  world_.PlayAction(1);
  EXPECT_TRUE(learner_.episode_over());

  UseImmediateEnds();
  world_.end_of_episode(kFall);
  world_.start_of_episode();
  EXPECT_TRUE(learner_.episode_over());
  EXPECT_EQ(learner_.action_count(), 0);

  world_.start_of_episode();
  EXPECT_FALSE(learner_.episode_over());  // ended the one episode only
}

TEST_F(PengQLambdaTest, SchedulesFollowTheFinishedEpisodes) {
  EXPECT_EQ(learner_.learning_rate(), 0.3);
  EXPECT_EQ(learner_.temperature(), 5);
  for (int episode = 0; episode < 896; ++episode) {
    EXPECT_GT(learner_.learning_rate(), 0.05);
    world_.start_of_episode();
    world_.end_of_episode(kTimeIsUp);
    EXPECT_EQ(learner_.episode_count(), episode);  // not before the last update
    world_.end_of_action();
  }
  EXPECT_EQ(learner_.episode_count(), 896);
  EXPECT_EQ(learner_.learning_rate(), 0.05);
  EXPECT_NEAR(learner_.temperature(), 0.13882209085, 1e-11);
}

TEST_F(PengQLambdaTest, ShowsWhatTheLastEpisodeWasLearnedWith) {
  const std::vector<LearnerCurve>& curves = learner_.curves();
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[0].name, "learning_rate");
  EXPECT_EQ(curves[1].name, "temperature");
  for (int episode = 0; episode < 3; ++episode) {
    const double rate = learner_.learning_rate();
    const double temperature = learner_.temperature();
    world_.start_of_episode();
    world_.end_of_episode(kTimeIsUp);
    world_.end_of_action();
    EXPECT_EQ(*curves[0].value, rate);
    EXPECT_EQ(*curves[1].value, temperature);
    EXPECT_LT(learner_.learning_rate(), rate);  // in the next one
  }
}

TEST(PengQLambda, EqualSeedsChooseEqualActions) {
  const auto actions = [](uint64_t seed) {
    Context context = HumanoidContext();
    context.seed = seed;
    PengQLambda learner("learner", context);
    FakeWorld world(50, 2);
    world.ConnectTo(learner);
    world.start_of_episode();
    std::vector<int> chosen;
    for (int i = 0; i < 20; ++i) {
      chosen.push_back(world.action);
      world.PlayAction(1);
    }
    return chosen;
  };
  EXPECT_EQ(actions(1), actions(1));
  EXPECT_NE(actions(1), actions(2));
}

TEST_F(PengQLambdaTest, StopsLearningAndKeepsItsTemperature) {
  const auto play_episode = [this] {
    world_.start_of_episode();
    world_.PlayAction(10);
    world_.end_of_episode(kGoal);
    world_.PlayAction(1);
  };
  play_episode();
  const double learned = theta();
  EXPECT_NE(learned, 0);
  const double temperature = learner_.temperature();
  learner_.StopLearning();
  for (int episode = 0; episode < 3; ++episode) play_episode();
  EXPECT_EQ(theta(), learned);
  EXPECT_EQ(learner_.temperature(), temperature);
  EXPECT_EQ(learner_.learning_rate(), 0);
}

TEST_F(PengQLambdaTest, ParametersAreChecked) {
  const auto complaint = [this](const char* parameter, double value) {
    return UserErrorOf([&] { learner_.Set(parameter, value); });
  };
  EXPECT_THAT(complaint("discount", 1.1), HasSubstr("learner.discount"));
  EXPECT_THAT(complaint("trace_decay", -0.1), HasSubstr("learner.trace_decay"));
  EXPECT_THAT(complaint("temperature", -1), HasSubstr("learner.temperature"));
  EXPECT_THAT(UserErrorOf([this] { learner_.Set("episode_end", std::string("imediate")); }),
              HasSubstr("`immediate`"));
  learner_.Set("learning_rate", 0.01);
  EXPECT_THAT(UserErrorOf([this] { learner_.Start(); }),
              AllOf(HasSubstr("learning_rate_min"), HasSubstr("0.05"), HasSubstr("0.01")));
}

TEST(PengQLambda, NeedsItsInputs) {
  PengQLambda learner("learner", HumanoidContext());
  EXPECT_THAT(UserErrorOf([&] { learner.Start(); }), HasSubstr("learner.features"));
}

}  // namespace
}  // namespace runtime
