#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <sstream>
#include <vector>

#include "runtime/training/learning/peng_q_lambda.h"
#include "tests/runtime/training/learning/fake_world.h"
#include "tests/runtime/training/learning/user_error_of.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// A learner in a world whose states and rewards depend on the actions in an arbitrary, fixed way.
class Trainee {
 public:
  explicit Trainee(uint64_t seed, int actions = 12, int features = 7)
      : world_(actions, features), learner_("learner", ContextWith(seed)) {
    world_.ConnectTo(learner_);
    learner_.Start();
  }

  void Train(int episodes) {
    for (int episode = 0; episode < episodes; ++episode) {
      place_ = 0.1;
      ShowPlace();
      world_.start_of_episode();
      for (int action = 0; action < 15; ++action) {
        chosen_.push_back(world_.action);
        place_ = std::fmod(3.7 * place_ + 0.31 * world_.action, 1.0);
        ShowPlace();
        if (action == 14) world_.end_of_episode(kTimeIsUp);
        world_.PlayAction(place_ - 0.4);
      }
      returns_.push_back(learner_.episode_return());
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
  std::string LoadComplaint(const std::string& checkpoint) {
    return UserErrorOf([&] { Load(checkpoint); });
  }

  const PengQLambda& learner() const { return learner_; }
  const std::vector<int>& chosen() const { return chosen_; }
  const std::vector<double>& returns() const { return returns_; }
  void Forget() {
    chosen_.clear();
    returns_.clear();
  }

 private:
  static Context ContextWith(uint64_t seed) {
    Context context = HumanoidContext();
    context.seed = seed;
    return context;
  }

  void ShowPlace() {
    for (int i = 0; i < world_.features.size(); ++i) {
      world_.features[i] = std::exp(-std::pow(5 * place_ - i, 2));
    }
    world_.features /= world_.features.sum();
  }

  FakeWorld world_;
  PengQLambda learner_;
  double place_ = 0;
  std::vector<int> chosen_;
  std::vector<double> returns_;
};

TEST(PengQLambdaCheckpoint, TrainingGoesOnBitForBit) {
  Trainee trainee(1);
  trainee.Train(5);
  const std::string checkpoint = trainee.Saved();
  trainee.Forget();
  trainee.Train(5);

  Trainee resumed(2);  // another seed: the numbers come from the checkpoint
  resumed.Load(checkpoint);
  EXPECT_EQ(resumed.learner().episode_count(), 5);
  resumed.Train(5);
  EXPECT_EQ(resumed.chosen(), trainee.chosen());
  EXPECT_EQ(resumed.returns(), trainee.returns());
  EXPECT_EQ(resumed.Saved(), trainee.Saved());
}

TEST(PengQLambdaCheckpoint, ALearnerCanGoBack) {
  Trainee trainee(1);
  trainee.Train(2);
  const std::string checkpoint = trainee.Saved();
  trainee.Forget();
  trainee.Train(3);
  const std::vector<int> chosen = trainee.chosen();
  trainee.Load(checkpoint);
  trainee.Forget();
  trainee.Train(3);
  EXPECT_EQ(trainee.chosen(), chosen);
}

TEST(PengQLambdaCheckpoint, HoldsALearnerThatHasNotLearned) {
  Trainee trainee(1);
  Trainee resumed(2);
  resumed.Load(trainee.Saved());
  trainee.Train(2);
  resumed.Train(2);
  EXPECT_EQ(resumed.Saved(), trainee.Saved());
}

TEST(PengQLambdaCheckpoint, OneOfAnotherAgentIsRefused) {
  Trainee trainee(1);
  trainee.Train(1);
  Trainee other(1, 12, 8);
  other.Load(trainee.Saved());
  EXPECT_THAT(UserErrorOf([&] { other.Train(1); }),
              AllOf(HasSubstr("12 actions and 7 features"), HasSubstr("12 and 8")));
}

TEST(PengQLambdaCheckpoint, ADamagedOneIsRefusedAndChangesNothing) {
  Trainee trainee(1);
  trainee.Train(1);
  const std::string checkpoint = trainee.Saved();
  const std::string first_word = checkpoint.substr(0, checkpoint.find(' '));
  for (const std::string& damaged :
       {std::string(), std::string("something else"), "x" + checkpoint,
        checkpoint.substr(0, checkpoint.size() - 1), checkpoint.substr(0, 1000),
        first_word + " -1 " + checkpoint.substr(first_word.size() + 3)}) {
    EXPECT_THAT(trainee.LoadComplaint(damaged), HasSubstr("`learner` is damaged"));
  }
  EXPECT_EQ(trainee.Saved(), checkpoint);
}

}  // namespace
}  // namespace runtime
