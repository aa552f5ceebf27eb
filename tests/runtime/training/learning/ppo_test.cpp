#include "runtime/training/learning/ppo.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "tests/runtime/training/learning/continuous_world.h"
#include "tests/runtime/training/learning/user_error_of.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// A learner in a world whose observations follow from its actions.
class PpoTrainee {
 public:
  explicit PpoTrainee(uint64_t seed = 1, int observation_size = 3)
      : world_(observation_size, 2),
        learner_("learner", {.robot = &Humanoid(), .task = {}, .seed = seed}) {
    learner_.Set("hidden", std::vector<double>{8, 8});
    learner_.Set("batch", int64_t{40});
    learner_.Set("minibatch", int64_t{16});
    learner_.Set("deviation", 0.5);
    learner_.Set("deviation_decisions", int64_t{1000});
    world_.ConnectTo(learner_);
    learner_.Start();
  }

  void Train(int episodes) {
    for (int i = 0; i < episodes; ++i) PlayEpisode(15, i % 2 == 0 ? kTimeIsUp : kFall);
  }
  void PlayEpisode(int actions, const EpisodeEnd& end) {
    world_.observation.setZero();
    world_.start_of_episode();
    for (int i = 0; i < actions; ++i) {
      trace_.push_back(world_.action[0]);
      Move();
      if (i + 1 == actions) world_.end_of_episode(end);
      world_.end_of_action();
    }
  }

  std::string Saved() const {
    std::ostringstream stream;
    learner_.Save(stream);
    return stream.str();
  }
  void Load(const std::string& checkpoint) {
    std::istringstream stream(checkpoint);
    learner_.Load(stream);
  }

  ContinuousWorld& world() { return world_; }
  Ppo& learner() { return learner_; }
  // The first element of all actions.
  std::vector<double>& trace() { return trace_; }

 private:
  void Move() {
    const double place = world_.observation[0] + world_.action.sum();
    for (Eigen::Index i = 0; i < world_.observation.size(); ++i) {
      world_.observation[i] = std::sin(static_cast<double>(i + 1) * place);
    }
    world_.reward(-std::abs(place));
  }

  ContinuousWorld world_;
  Ppo learner_;
  std::vector<double> trace_;
};

TEST(Ppo, LearnsAfterTheEpisodeThatFillsABatch) {
  PpoTrainee trainee;
  trainee.Train(2);
  EXPECT_EQ(trainee.learner().state().batch.decisions(), 30);
  EXPECT_EQ(trainee.learner().state().decisions, 0);
  trainee.Train(1);
  EXPECT_EQ(trainee.learner().state().batch.decisions(), 0);
  EXPECT_EQ(trainee.learner().state().decisions, 45);
  EXPECT_EQ(trainee.learner().passed_over_count(), 0);
}

TEST(Ppo, ADivergedEpisodeIsNotLearnedFrom) {
  PpoTrainee trainee;
  trainee.PlayEpisode(10, kTimeIsUp);
  trainee.PlayEpisode(20, kBlownUp);
  EXPECT_EQ(trainee.learner().state().batch.decisions(), 10);
}

TEST(Ppo, AnEpisodeThatEndsAtItsStartHasNothingToLearnFrom) {
  PpoTrainee trainee;
  trainee.world().end_of_episode(kFall);
  trainee.world().start_of_episode();
  EXPECT_TRUE(trainee.learner().episode_over());
  EXPECT_EQ(trainee.learner().state().batch.decisions(), 0);
}

TEST(Ppo, DeviationFallsWithTheDecisionsThatWereLearnedFrom) {
  PpoTrainee trainee;
  const auto deviation = [&] {
    return std::exp(trainee.learner().state().policy.log_deviations[0]);
  };
  trainee.Train(1);
  EXPECT_NEAR(deviation(), 0.5, 1e-6);
  trainee.Train(3);  // 45 of 1000 decisions were learned from, 15 were not
  EXPECT_NEAR(deviation(), 0.5 - 0.4 * 0.045, 1e-6);
  trainee.Train(80);
  EXPECT_NEAR(deviation(), 0.1, 1e-6);
}

TEST(Ppo, DeviationCanBeLearned) {
  PpoTrainee trainee;
  trainee.learner().Set("deviation_mode", std::string("learned"));
  trainee.learner().Start();
  trainee.Train(9);
  const Eigen::VectorXf& logs = trainee.learner().state().policy.log_deviations;
  EXPECT_NE(logs[0], logs[1]);
  EXPECT_GE(logs.minCoeff(), std::log(0.1f));
}

// Of the noise of the actions of one episode, one after the other; the mean of an untrained policy
// does not change as long as the observation does not.
TEST(Ppo, NoiseIsAsCorrelatedAsItsParameterSays) {
  for (const double correlation : {0.0, 0.8}) {
    PpoTrainee trainee;
    trainee.learner().Set("noise_correlation", correlation);
    trainee.learner().Set("batch", int64_t{1'000'000});
    ContinuousWorld& world = trainee.world();
    world.start_of_episode();
    std::vector<double> actions;
    for (int i = 0; i < 20'000; ++i) {
      actions.push_back(world.action[0]);
      world.end_of_action();
    }
    const auto count = static_cast<double>(actions.size());
    double mean = 0, square = 0, product = 0;
    for (const double action : actions) mean += action / count;
    for (size_t i = 0; i < actions.size(); ++i) {
      square += (actions[i] - mean) * (actions[i] - mean) / count;
      if (i > 0) product += (actions[i] - mean) * (actions[i - 1] - mean) / count;
    }
    EXPECT_NEAR(std::sqrt(square), 0.5, 0.03) << correlation;
    EXPECT_NEAR(product / square, correlation, 0.03);
  }
}

TEST(Ppo, WithoutLearningActsByTheMeanAndChangesNothing) {
  PpoTrainee trainee;
  trainee.Train(6);
  trainee.learner().StopLearning();
  const std::string before = trainee.Saved();
  trainee.trace().clear();
  trainee.Train(1);
  const std::vector<double> once = trainee.trace();
  trainee.trace().clear();
  trainee.Train(1);
  EXPECT_EQ(trainee.trace(), once);
  EXPECT_EQ(trainee.Saved(), before);
  const PpoState& state = trainee.learner().state();
  Eigen::MatrixXf observation = Eigen::MatrixXf::Zero(3, 1);
  state.Normalize(observation);
  Mlp<float>::Pass pass;
  EXPECT_EQ(once.front(), state.policy.mean.Forward(observation, pass)(0, 0));
}

TEST(Ppo, AnotherTaskIsNotPaidWithDecisionsOfTheOldOne) {
  PpoTrainee trainee;
  trainee.Train(2);
  trainee.world().start_of_episode();
  trainee.world().PlayAction(1);
  trainee.learner().ForgetCredit();
  EXPECT_EQ(trainee.learner().state().batch.decisions(), 0);
  trainee.world().PlayAction(1);  // was selected before
  trainee.world().PlayAction(2);
  trainee.world().end_of_episode(kTimeIsUp);
  ASSERT_EQ(trainee.learner().state().batch.decisions(), 2);
  EXPECT_EQ(trainee.learner().state().batch.rewards()[0], 2);
}

// Each choice forgets what it names and nothing else.
TEST(Ppo, WhatASwappedTaskKeepsIsChosen) {
  const auto swapped = [](const std::string& parameter) {
    PpoTrainee trainee;
    trainee.Train(9);
    if (!parameter.empty()) trainee.learner().Set(parameter, std::string("forget"));
    trainee.learner().ForgetCredit();
    return trainee.learner().state();
  };
  const PpoState kept = swapped("");
  EXPECT_GT(kept.returns.Deviation(0), 1e-3);
  EXPECT_NE(kept.rate_factor, 1);
  for (const std::string parameter : {"new_task_value", "new_task_scale", "new_task_optimizers"}) {
    const PpoState state = swapped(parameter);
    EXPECT_EQ(state.policy.mean.weights(), kept.policy.mean.weights());
    EXPECT_EQ(state.decisions, kept.decisions);
    EXPECT_EQ(state.value.weights() == kept.value.weights(), parameter != "new_task_value");
    EXPECT_EQ(state.returns.Deviation(0) == kept.returns.Deviation(0),
              parameter != "new_task_scale");
    EXPECT_EQ(state.rate_factor == kept.rate_factor, parameter != "new_task_optimizers");
  }
}

TEST(Ppo, ForgetsAllButTheRandomNumbers) {
  PpoTrainee trainee;
  trainee.Train(6);
  const std::string before = trainee.Saved();
  trainee.learner().Forget();
  trainee.Train(1);
  const PpoState& state = trainee.learner().state();
  EXPECT_EQ(state.decisions, 0);
  EXPECT_EQ(state.batch.decisions(), 15);
  EXPECT_NEAR(std::exp(state.policy.log_deviations[0]), 0.5, 1e-6);
  PpoTrainee first;
  first.Train(1);
  EXPECT_NE(first.trace().front(), trainee.trace().back());
  EXPECT_NE(first.learner().state().policy.mean.weights(), state.policy.mean.weights());
}

TEST(Ppo, LearningRateFollowsTheDivergence) {
  PpoTrainee trainee;
  trainee.learner().Set("kl_target", 1e3);  // never reached
  trainee.Train(3);
  EXPECT_DOUBLE_EQ(trainee.learner().state().rate_factor, 1.5);
  trainee.learner().Set("kl_target", 1e-9);
  trainee.Train(3);
  EXPECT_DOUBLE_EQ(trainee.learner().state().rate_factor, 1);
  trainee.learner().Set("kl_target", 0.0);
  trainee.Train(3);
  EXPECT_DOUBLE_EQ(trainee.learner().state().rate_factor, 1);
  EXPECT_EQ(trainee.learner().state().figures.learning_rate, 3e-4);
}

TEST(Ppo, WhatIsNotFiniteIsPassedOver) {
  PpoTrainee trainee;
  trainee.world().start_of_episode();
  for (int i = 0; i < 48; ++i) {
    trainee.world().observation.setConstant(1e300);
    if (i == 47) trainee.world().end_of_episode(kTimeIsUp);
    trainee.world().PlayAction(i % 2 == 0 ? 1e300 : -1e300);
  }
  EXPECT_EQ(trainee.learner().state().decisions, 48);
  EXPECT_TRUE(trainee.learner().state().policy.mean.weights().allFinite());
  EXPECT_TRUE(trainee.learner().state().value.weights().allFinite());
  trainee.Train(3);
  EXPECT_TRUE(std::isfinite(trainee.trace().back()));
}

TEST(Ppo, HiddenSizesAreWholeNumbers) {
  Ppo learner("learner", HumanoidContext());
  ContinuousWorld world(1, 1);
  world.ConnectTo(learner);
  learner.Set("hidden", std::vector<double>{64, 2.5});
  EXPECT_THAT(UserErrorOf([&] { learner.Start(); }), HasSubstr("`learner.hidden`"));
}

TEST(Ppo, DeviationDoesNotRise) {
  Ppo learner("learner", HumanoidContext());
  ContinuousWorld world(1, 1);
  world.ConnectTo(learner);
  learner.Set("deviation_min", 1.0);
  EXPECT_THAT(UserErrorOf([&] { learner.Start(); }),
              AllOf(HasSubstr("`learner.deviation_min` is 1"), HasSubstr("0.3")));
}

TEST(PpoCheckpoint, TrainingGoesOnBitForBit) {
  PpoTrainee trainee(1);
  trainee.Train(5);  // two of them wait for the next update
  const std::string checkpoint = trainee.Saved();
  trainee.trace().clear();
  trainee.Train(5);

  PpoTrainee resumed(1);
  resumed.Load(checkpoint);
  EXPECT_EQ(resumed.Saved(), checkpoint);
  resumed.learner().SetNextEpisode(6);
  resumed.Train(5);
  EXPECT_EQ(resumed.trace(), trainee.trace());
  EXPECT_EQ(resumed.Saved(), trainee.Saved());
}

TEST(PpoCheckpoint, HoldsALearnerThatHasNotLearned) {
  PpoTrainee trainee(1);
  PpoTrainee resumed(1);
  resumed.Load(trainee.Saved());
  trainee.Train(4);
  resumed.Train(4);
  EXPECT_EQ(resumed.Saved(), trainee.Saved());
}

TEST(Ppo, TakesOverWhatOthersHaveRunAsIfItHadRunThat) {
  const auto play = [](PpoTrainee& trainee, int64_t episode) {
    trainee.PlayEpisode(15, episode % 2 == 0 ? kFall : kTimeIsUp);
  };
  PpoTrainee alone(1);
  for (int64_t episode = 1; episode <= 9; ++episode) play(alone, episode);

  PpoTrainee leader(1);
  play(leader, 1);
  std::vector<PpoTrainee> followers(3);
  std::vector<int64_t> rounds;
  for (int64_t next = 2; next <= 9; next += rounds.back()) {
    rounds.push_back(leader.learner().EpisodesAlike());
    ASSERT_LE(rounds.back(), 3);
    const int64_t policy = leader.learner().policy_number();
    for (int64_t i = rounds.back(); i-- > 0;) {
      PpoTrainee& follower = followers[static_cast<size_t>(i)];
      follower.learner().Follow(leader.learner(), next + i);
      if (i == 1) follower.world().start_of_episode();  // and no more than that
      follower.learner().Follow(leader.learner(), next + i);
      play(follower, next + i);
    }
    for (int64_t i = 0; i < rounds.back(); ++i) {
      EXPECT_EQ(leader.learner().policy_number(), policy);
      leader.learner().TakeOver(followers[static_cast<size_t>(i)].learner());
      EXPECT_EQ(leader.learner().action_count(), 15);
    }
    EXPECT_EQ(leader.learner().policy_number(), policy + 1);
  }
  EXPECT_EQ(rounds, (std::vector<int64_t>{2, 3, 3}));
  EXPECT_EQ(leader.Saved(), alone.Saved());
  EXPECT_EQ(leader.learner().episode_return(), alone.learner().episode_return());
}

TEST(PpoCheckpoint, OneOfAnotherAgentIsRefused) {
  PpoTrainee trainee;
  trainee.Train(1);
  PpoTrainee other(1, 4);
  other.Load(trainee.Saved());
  EXPECT_THAT(
      UserErrorOf([&] { other.Train(1); }),
      AllOf(HasSubstr("observations of 3 elements and actions of 2"), HasSubstr("has 4 and 2")));
}

TEST(PpoCheckpoint, ADamagedOneIsRefusedAndChangesNothing) {
  PpoTrainee trainee;
  trainee.Train(4);
  const std::string checkpoint = trainee.Saved();
  for (const std::string& damaged :
       {std::string(), std::string("something else"), "x" + checkpoint,
        checkpoint.substr(0, checkpoint.size() - 1), checkpoint.substr(0, 8000)}) {
    EXPECT_THAT(UserErrorOf([&] { trainee.Load(damaged); }), HasSubstr("`learner` is damaged"));
  }
  EXPECT_EQ(trainee.Saved(), checkpoint);
}

}  // namespace
}  // namespace runtime
