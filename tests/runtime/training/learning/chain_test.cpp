// The learner in the smallest world that needs it to look ahead.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/runtime/training/learning/fake_world.h"

namespace runtime {
namespace {

// Places 0 to 4 in a row, episodes start in 0. Action 1 goes right, action 0 left; in place 0 going
// left brings 0.05 at once, and reaching place 4 brings 1 and is the goal. With gamma = 0.9 staying
// is worth at most 0.05 / (1 - 0.9) = 0.5, going right from place s 0.9^(3 - s): at least 0.729.
class Chain {
 public:
  explicit Chain(const char* episode_end) {
    learner_.Set("episode_end", std::string(episode_end));
    learner_.Set("temperature", 1.0);
    learner_.Set("temperature_decay", 0.02);
    world_.ConnectTo(learner_);
    learner_.Start();
  }

  // Returns the actions it took.
  int PlayEpisode() {
    GoTo(0);
    world_.start_of_episode();
    for (int action = 1; !learner_.episode_over(); ++action) {
      const double reward = Move(world_.action);
      world_.reward(reward);
      if (place_ == 4) {
        world_.end_of_episode(kGoal);
      } else if (action >= 30) {
        world_.end_of_episode(kTimeIsUp);
      }
      world_.end_of_action();
    }
    return learner_.action_count();
  }

  double Value(int place, int action) const { return learner_.q_lambda().theta()(action, place); }

 private:
  double Move(int action) {
    const double reward = place_ == 3 && action == 1 ? 1 : place_ == 0 && action == 0 ? 0.05 : 0;
    GoTo(std::max(0, place_ + (action == 1 ? 1 : -1)));
    return reward;
  }
  void GoTo(int place) {
    place_ = place;
    world_.features.setZero();
    world_.features[place] = 1;
  }

  FakeWorld world_{2, 5};
  PengQLambda learner_{"learner", HumanoidContext()};
  int place_ = 0;
};

TEST(Chain, LearnsToGoRightEverywhere) {
  Chain chain("immediate");
  for (int episode = 0; episode < 600; ++episode) chain.PlayEpisode();
  for (int place = 0; place < 4; ++place) EXPECT_GT(chain.Value(place, 1), chain.Value(place, 0));
  EXPECT_NEAR(chain.Value(3, 1), 1, 0.01);
  EXPECT_NEAR(chain.Value(2, 1), 0.9, 0.02);
  EXPECT_NEAR(chain.Value(1, 1), 0.81, 0.03);
  EXPECT_NEAR(chain.Value(0, 1), 0.729, 0.04);
  EXPECT_EQ(chain.PlayEpisode(), 4);
}

// The goal's own value counts, but no action is ever taken there: it stays 0.
TEST(Chain, OriginalEndsFindTheSameWay) {
  Chain chain("after_action");
  for (int episode = 0; episode < 600; ++episode) chain.PlayEpisode();
  EXPECT_EQ(chain.PlayEpisode(), 4);
  EXPECT_EQ(chain.Value(4, 0), 0);
  EXPECT_EQ(chain.Value(4, 1), 0);
}

}  // namespace
}  // namespace runtime
