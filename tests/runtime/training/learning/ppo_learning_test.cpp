// The learner in small worlds of which it is known what can be learned.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "runtime/training/learning/ppo.h"
#include "tests/runtime/training/learning/continuous_world.h"

namespace runtime {
namespace {

constexpr double kDiscount = 0.9;

class PpoWorld {
 public:
  PpoWorld(int observation_size, int action_size) : world_(observation_size, action_size) {
    learner_.Set("hidden", std::vector<double>{32, 32});
    learner_.Set("batch", int64_t{400});
    learner_.Set("minibatch", int64_t{64});
    learner_.Set("deviation", 0.5);
    learner_.Set("deviation_decisions", int64_t{20'000});
    world_.ConnectTo(learner_);
    learner_.Start();
  }

  // What an observation is worth, in the units of the rewards.
  double ValueOf(const Eigen::VectorXd& observation) const {
    const PpoState& state = learner_.state();
    Eigen::MatrixXf normalized = observation.cast<float>();
    state.Normalize(normalized);
    Mlp<float>::Pass pass;
    return state.value.Forward(normalized, pass)(0, 0) * state.returns.Deviation(0);
  }

 protected:
  ContinuousWorld world_;
  Ppo learner_{"learner", HumanoidContext()};
};

// Places 0 to 4 in a row, episodes start in 0. An action above 0 goes right, others left; in place
// 0 going left brings 0.05 at once, and reaching place 4 brings 1 and is the goal. With gamma = 0.9
// staying is worth at most 0.05 / (1 - 0.9) = 0.5, going right from place s 0.9^(3 - s).
class ContinuousChain : public PpoWorld {
 public:
  ContinuousChain() : PpoWorld(5, 1) { learner_.Set("discount", kDiscount); }

  // Returns the actions that it took.
  int PlayEpisode() {
    GoTo(0);
    world_.start_of_episode();
    while (!learner_.episode_over()) {
      const bool goes_right = world_.action[0] > 0;
      const double reward = goes_right ? (place_ == 3 ? 1 : 0) : (place_ == 0 ? 0.05 : 0);
      GoTo(std::max(0, place_ + (goes_right ? 1 : -1)));
      world_.reward(reward);
      if (place_ == 4) {
        world_.end_of_episode(kGoal);
      } else if (learner_.action_count() >= 30) {
        world_.end_of_episode(kTimeIsUp);
      } else {
        world_.end_of_action();
      }
    }
    return learner_.action_count();
  }
  int PlayBestEpisode() {
    learner_.StopLearning();
    return PlayEpisode();
  }
  double ValueAt(int place) const { return ValueOf(Eigen::VectorXd::Unit(5, place)); }

 private:
  void GoTo(int place) {
    place_ = place;
    world_.observation = Eigen::VectorXd::Unit(5, place);
  }

  int place_ = 0;
};

TEST(PpoLearning, GoesToTheEndOfTheChain) {
  ContinuousChain chain;
  for (int episode = 0; episode < 3000; ++episode) chain.PlayEpisode();
  EXPECT_NEAR(chain.ValueAt(3), 1, 0.1);
  EXPECT_NEAR(chain.ValueAt(2), 0.9, 0.1);
  EXPECT_NEAR(chain.ValueAt(1), 0.81, 0.1);
  EXPECT_NEAR(chain.ValueAt(0), 0.729, 0.1);
  EXPECT_EQ(chain.PlayBestEpisode(), 4);
}

// One place, and each action brings 1: for ever that is worth 1 / (1 - 0.9) = 10.
class Fountain : public PpoWorld {
 public:
  Fountain() : PpoWorld(1, 1) {
    learner_.Set("discount", kDiscount);
    world_.observation.setOnes();
  }
  void PlayEpisode(const EpisodeEnd& end) {
    world_.start_of_episode();
    for (int i = 0; i < 4; ++i) world_.PlayAction(1);
    world_.reward(1);
    world_.end_of_episode(end);
  }
  double Value() const { return ValueOf(Eigen::VectorXd::Ones(1)); }
};

TEST(PpoLearning, ALimitDoesNotEndWhatAStateIsWorth) {
  Fountain fountain;
  for (int episode = 0; episode < 6000; ++episode) fountain.PlayEpisode(kTimeIsUp);
  EXPECT_NEAR(fountain.Value(), 10, 1);
}

// From 1 to 5 actions are left: 1, 1.9, 2.71, 3.439, 4.0951, on average 2.63.
TEST(PpoLearning, AFailureEndsIt) {
  Fountain fountain;
  for (int episode = 0; episode < 1000; ++episode) fountain.PlayEpisode(kFall);
  EXPECT_NEAR(fountain.Value(), 2.63, 0.3);
}

// A pole on a cart that is pushed to and fro (Barto, Sutton and Anderson, 1983), by up to 10 N and
// 50 times a second; it fails where the pole leans by more than 12 degrees or the cart is more than
// 2.4 m away.
class CartPole : public PpoWorld {
 public:
  static constexpr int kMostActions = 200;

  CartPole() : PpoWorld(4, 1) {}

  // Returns the actions until it failed.
  int PlayEpisode() {
    for (double& x : world_.observation) x = 0.05 * (2 * random_.Uniform() - 1);
    world_.start_of_episode();
    while (!learner_.episode_over()) {
      Push(10 * std::clamp(world_.action[0], -1.0, 1.0));
      world_.reward(1);
      const bool has_failed = std::abs(world_.observation[0]) > 2.4 ||
                              std::abs(world_.observation[2]) > 12 * M_PI / 180;
      if (has_failed) {
        world_.end_of_episode(kFall);
      } else if (learner_.action_count() >= kMostActions) {
        world_.end_of_episode(kTimeIsUp);
      } else {
        world_.end_of_action();
      }
    }
    return learner_.action_count();
  }
  void StopLearning() { learner_.StopLearning(); }

 private:
  void Push(double force) {
    constexpr double kCart = 1, kPole = 0.1, kLength = 0.5, kGravity = 9.8, kTimeStep = 0.02;
    Eigen::VectorXd& x = world_.observation;  // place, velocity, angle, rate
    const double sine = std::sin(x[2]), cosine = std::cos(x[2]);
    const double push = (force + kPole * kLength * x[3] * x[3] * sine) / (kCart + kPole);
    const double turn = (kGravity * sine - cosine * push) /
                        (kLength * (4.0 / 3 - kPole * cosine * cosine / (kCart + kPole)));
    const double acceleration = push - kPole * kLength * turn * cosine / (kCart + kPole);
    x += kTimeStep * Eigen::Vector4d(x[1], acceleration, x[3], turn);
  }

  Random random_{7};
};

TEST(PpoLearning, BalancesThePoleOfACart) {
  CartPole cart_pole;
  int first = 0;
  for (int episode = 0; episode < 20; ++episode) first += cart_pole.PlayEpisode();
  EXPECT_LT(first, 20 * 60);
  for (int episode = 0; episode < 100; ++episode) cart_pole.PlayEpisode();
  cart_pole.StopLearning();
  for (int episode = 0; episode < 5; ++episode) {
    EXPECT_EQ(cart_pole.PlayEpisode(), CartPole::kMostActions);
  }
}

}  // namespace
}  // namespace runtime
