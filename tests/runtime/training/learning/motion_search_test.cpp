#include "runtime/training/learning/motion_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <sstream>

#include "tests/runtime/training/learning/fake_state.h"
#include "tests/runtime/training/learning/fake_world.h"
#include "tests/runtime/training/learning/user_error_of.h"

namespace runtime {
namespace {

using Eigen::VectorXd;
using testing::HasSubstr;

// Pays for how near an action is to (0.4, -0.2, 0.1).
double Nearness(const VectorXd& action) {
  return -(action - Eigen::Vector3d(0.4, -0.2, 0.1)).norm();
}

// Environment, task and action space of a search in one. An episode has two actions, each of which
// pays a half.
class SearchWorld : public Module {
 public:
  SearchWorld(MotionSearch& learner, int numbers = 3)
      : Module("world"), learner_(learner), standstill(VectorXd::Zero(numbers)) {
    for (const char* port : {"start_of_episode", "reward", "end_of_action", "end_of_episode",
                             "execute", "standstill", "frequency"}) {
      Port::Connect(FindPort(port), learner.FindPort(port));
    }
    learner.Start();
  }

  // Runs an episode and returns its candidate.
  VectorXd RunEpisode(const EpisodeEnd& end = kTimeIsUp) {
    start_of_episode();
    const VectorXd candidate = action;
    reward(value(action) / 2);
    end_of_action();
    between_actions();
    EXPECT_EQ(action, candidate);  // throughout the episode
    reward(value(action) / 2);
    end_of_episode(end);
    EXPECT_TRUE(learner_.episode_over());
    candidates.push_back(candidate);
    return candidate;
  }
  void RunEpisodes(int count) {
    for (int i = 0; i < count; ++i) RunEpisode();
  }

  std::function<double(const VectorXd&)> value = Nearness;
  std::function<void()> between_actions = [] {};
  VectorXd action;
  std::vector<VectorXd> candidates;

 private:
  void Execute(const VectorXd& wanted) { action = wanted; }

  MotionSearch& learner_;

 public:
  VectorXd standstill;
  double frequency = 2;
  Signal<> start_of_episode{this, "start_of_episode"};
  Signal<double> reward{this, "reward"};
  Signal<> end_of_action{this, "end_of_action"};
  Signal<EpisodeEnd> end_of_episode{this, "end_of_episode"};

 private:
  Slot<const VectorXd&> execute_{this, "execute", Bind<&SearchWorld::Execute>{}};
  Out<VectorXd> standstill_out_{this, "standstill", &standstill};
  Out<double> frequency_out_{this, "frequency", &frequency};
};

class MotionSearchTest : public testing::Test {
 protected:
  double CurveNamed(const std::string& name) const {
    for (const LearnerCurve& curve : learner_.curves()) {
      if (curve.name == name) return *curve.value;
    }
    ADD_FAILURE() << name;
    return 0;
  }

  MotionSearch learner_{"learner", HumanoidContext()};
  SearchWorld world_{learner_};
};

TEST_F(MotionSearchTest, FindsTheActionThatPaysMost) {
  world_.RunEpisodes(300);
  EXPECT_GT(learner_.best_return(), -0.02);
  EXPECT_EQ(Nearness(learner_.best()), learner_.best_return());
}

TEST_F(MotionSearchTest, ShowsHowItSearches) {
  world_.RunEpisodes(14);
  EXPECT_EQ(CurveNamed("generation"), 2);  // of 4 + 3 ln 3 = 7
  EXPECT_EQ(CurveNamed("population"), 7);
  EXPECT_EQ(CurveNamed("best"), learner_.best_return());
  EXPECT_EQ(CurveNamed("frequency"), 2);
  const double sigma = CurveNamed("sigma");
  world_.RunEpisodes(7);
  EXPECT_NE(CurveNamed("sigma"), sigma);
}

TEST_F(MotionSearchTest, ADivergedCandidateIsTheWorst) {
  world_.value = [](const VectorXd&) { return 1e9; };
  world_.RunEpisode(kBlownUp);
  EXPECT_TRUE(std::isnan(learner_.best_return()));
  EXPECT_EQ(learner_.best().size(), 0);
  world_.value = Nearness;
  const VectorXd next = world_.RunEpisode();
  EXPECT_EQ(learner_.best(), next);
  world_.value = [](const VectorXd&) { return std::numeric_limits<double>::quiet_NaN(); };
  world_.RunEpisode();
  EXPECT_EQ(learner_.best(), next);
}

TEST_F(MotionSearchTest, WithoutLearningItRepeatsTheBest) {
  world_.RunEpisodes(40);
  const VectorXd best = learner_.best();
  const VectorXd middle = learner_.search().middle();
  learner_.StopLearning();
  world_.value = [](const VectorXd&) { return 99.0; };
  EXPECT_EQ(world_.RunEpisode(), best);
  EXPECT_EQ(world_.RunEpisode(), best);
  learner_.Set("plays", std::string("middle"));
  EXPECT_EQ(world_.RunEpisode(), middle);
  EXPECT_EQ(learner_.search().middle(), middle);
  EXPECT_LT(learner_.best_return(), 0);
}

TEST_F(MotionSearchTest, BeforeItHasLearnedItRepeatsTheStandstill) {
  learner_.StopLearning();
  EXPECT_EQ(world_.RunEpisode(), world_.standstill);
}

TEST_F(MotionSearchTest, StartsAgainAroundTheBestWhereTheTaskIsAnother) {
  world_.RunEpisodes(100);
  const VectorXd best = learner_.best();
  world_.between_actions = [&] { learner_.ForgetCredit(); };
  world_.RunEpisode();
  world_.between_actions = [] {};
  EXPECT_TRUE(std::isnan(learner_.best_return()));
  EXPECT_LT((learner_.search().middle() - best).norm(), 1e-12);
  EXPECT_EQ(learner_.search().sigma(), 0.3);
  EXPECT_EQ(learner_.search().generation(), 0);
  world_.value = [](const VectorXd& action) { return -1000 - action.squaredNorm(); };
  world_.RunEpisodes(300);
  EXPECT_GT(learner_.best_return(), -1000.001);
}

TEST_F(MotionSearchTest, GoesOnWhereItIsIfItIsToldTo) {
  learner_.Set("new_task", std::string("continue"));
  world_.RunEpisodes(73);
  const double sigma = learner_.search().sigma();
  const VectorXd middle = learner_.search().middle();
  learner_.ForgetCredit();
  EXPECT_EQ(learner_.search().middle(), middle);
  world_.RunEpisodes(6);  // the generation begins again
  EXPECT_EQ(learner_.search().sigma(), sigma);
  world_.RunEpisode();
  EXPECT_NE(learner_.search().sigma(), sigma);
}

TEST_F(MotionSearchTest, ForgetsEverything) {
  world_.RunEpisodes(50);
  learner_.Forget();
  world_.RunEpisode();
  EXPECT_EQ(learner_.search().generation(), 0);
  EXPECT_EQ(learner_.search().sigma(), 0.3);
  EXPECT_EQ(learner_.search().middle(), world_.standstill);
}

TEST_F(MotionSearchTest, GoesOnBitForBitInTheMiddleOfAGeneration) {
  world_.RunEpisodes(33);
  std::ostringstream saved;
  learner_.Save(saved);
  std::istringstream stream(saved.str());
  MotionSearch restored("learner", HumanoidContext());
  SearchWorld same(restored);
  restored.Load(stream);
  restored.SetNextEpisode(34);
  world_.candidates.clear();
  world_.RunEpisodes(200);
  same.RunEpisodes(200);
  EXPECT_TRUE(same.candidates == world_.candidates);
  EXPECT_EQ(restored.best_return(), learner_.best_return());
  std::ostringstream one, other;
  learner_.Save(one);
  restored.Save(other);
  EXPECT_EQ(one.str(), other.str());
}

TEST_F(MotionSearchTest, TakesOverWhatOthersHaveRunAsIfItHadRunThat) {
  world_.RunEpisodes(120);
  MotionSearch leader("learner", HumanoidContext());
  SearchWorld own(leader);
  MotionSearch follower("learner", HumanoidContext());
  SearchWorld others(follower);
  EXPECT_EQ(leader.EpisodesAlike(), 1);  // it knows nothing of actions yet
  own.RunEpisode();
  for (int64_t episode = 2; episode <= 120; ++episode) {
    const int64_t told = (episode - 1) % 7;
    EXPECT_EQ(leader.EpisodesAlike(), 7 - told);
    if (told == 3) {  // this does not matter: it is run ahead, and once more in its turn
      follower.Follow(leader, episode + 2);
      others.RunEpisode();
    }
    follower.Follow(leader, episode);
    others.RunEpisode();
    const int64_t policy = leader.policy_number();
    leader.TakeOver(follower);
    EXPECT_EQ(leader.policy_number() == policy, told != 6);
    EXPECT_EQ(leader.action(), follower.action());
  }
  std::ostringstream one, other;
  learner_.Save(one);
  leader.Save(other);
  EXPECT_EQ(one.str(), other.str());
  EXPECT_EQ(leader.episode_return(), learner_.episode_return());
}

TEST_F(MotionSearchTest, ADamagedCheckpointChangesNothing) {
  world_.RunEpisodes(20);
  std::ostringstream saved;
  learner_.Save(saved);
  for (size_t length = 0; length < saved.str().size(); length += 101) {
    std::istringstream cut(saved.str().substr(0, length));
    EXPECT_THAT(UserErrorOf([&] { learner_.Load(cut); }), HasSubstr("is damaged"));
  }
  std::ostringstream after;
  learner_.Save(after);
  EXPECT_EQ(after.str(), saved.str());
}

TEST_F(MotionSearchTest, WhatItFoundFitsOneActionSpace) {
  world_.RunEpisodes(3);
  world_.standstill = VectorXd::Zero(4);
  EXPECT_THAT(UserErrorOf([&] { world_.start_of_episode(); }),
              HasSubstr("has searched actions of 3 numbers, and those of the agent have 4"));
}

TEST_F(MotionSearchTest, ParametersAreChecked) {
  learner_.Set("population", int64_t{1});
  EXPECT_THAT(UserErrorOf([&] { learner_.Start(); }), HasSubstr("at least 2, or 0"));
  EXPECT_THAT(UserErrorOf([&] { learner_.Set("sigma", 0.0); }), HasSubstr("learner.sigma"));
}

TEST(MotionSearch, EqualSeedsTryEqualCandidates) {
  const auto candidates = [](uint64_t seed) {
    Context context = HumanoidContext();
    context.seed = seed;
    MotionSearch learner("learner", context);
    SearchWorld world(learner);
    world.RunEpisodes(20);
    return world.candidates;
  };
  EXPECT_TRUE(candidates(1) == candidates(1));
  EXPECT_FALSE(candidates(1) == candidates(2));
}

}  // namespace
}  // namespace runtime
