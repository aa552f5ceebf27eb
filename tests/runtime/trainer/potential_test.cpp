// A potential leaves the best policy the best: in the smallest world in which a reward of the same
// shape does not, with the learner, the task module and the compiled tasks that runs have.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "runtime/core/module/module_graph.h"
#include "runtime/core/module/sensor_data.h"
#include "runtime/core/task/universal_task.h"
#include "runtime/training/learning/peng_q_lambda.h"
#include "runtime/training/run/task_modules.h"

namespace runtime {
namespace {

// Places 0 to 4 in a row, a meter apart, episodes start in 0. Action 1 goes right, action 0 left;
// each takes one time step of 1 s.
class Row : public Module {
 public:
  Row() : Module("world") {
    data_.data = place_.data();
    GoTo(0);
  }

  void StartEpisode() {
    GoTo(0);
    paid.clear();
    start_of_episode_();
  }
  void Move() {
    GoTo(std::clamp(place() + (action_ == 1 ? 1 : -1), 0.0, 4.0));
    end_of_time_step_(1);
    end_of_action_();
  }
  void EndEpisode(const EpisodeEnd& end) { end_of_episode_(end); }
  double place() const { return place_.x(); }

  // After the task has heard that an action is over, and before the learner does.
  std::optional<EpisodeEnd> end_with_action;
  // What each action of the episode brought.
  std::vector<double> paid;

 private:
  void GoTo(double place) {
    place_.x() = place;
    features_.setZero();
    features_[static_cast<Eigen::Index>(place)] = 1;
  }
  void StartAction() { paid.push_back(0); }
  void Execute(int action) { action_ = action; }
  void EndAction() {
    if (end_with_action) end_of_episode_(*end_with_action);
  }
  void Pay(double reward) {
    if (!paid.empty()) paid.back() += reward;
  }

  Eigen::Vector3d place_ = Eigen::Vector3d::Zero();
  int action_ = 0;
  int actions_ = 2;
  SensorData data_;
  Eigen::VectorXd features_ = Eigen::VectorXd::Zero(5);
  SensorOut sensor_{this, "base.position", &data_, SensorTypeText("vec3", "m")};
  Out<Eigen::VectorXd> features_out_{this, "features", &features_};
  Out<int> action_count_{this, "action_count", &actions_};
  Slot<int> execute_{this, "execute", Bind<&Row::Execute>{}};
  Slot<> start_of_action_{this, "start_of_action", Bind<&Row::StartAction>{}};
  Slot<> on_end_of_action_{this, "on_end_of_action", Bind<&Row::EndAction>{}};
  Slot<double> pay_{this, "pay", Bind<&Row::Pay>{}};
  Signal<> start_of_episode_{this, "start_of_episode"};
  Signal<double> end_of_time_step_{this, "end_of_time_step"};
  Signal<> end_of_action_{this, "end_of_action"};
  Signal<EpisodeEnd> end_of_episode_{this, "end_of_episode"};
};

class Chain {
 public:
  Chain(const std::string& task, double pull, const char* episode_end = "immediate") {
    context_.robot = &robot_;
    context_.task = std::make_shared<Plugin>(std::string(PLUGIN_FOLDER) + "/" + task + ".so");
    context_.seed = 1;
    world_ = &static_cast<Row&>(graph_.Add(std::make_unique<Row>()));
    task_ =
        &static_cast<UniversalTask&>(graph_.Add(std::make_unique<UniversalTask>("task", context_)));
    learner_ =
        &static_cast<PengQLambda&>(graph_.Add(std::make_unique<PengQLambda>("learner", context_)));
    for (const auto& [from, to] : std::vector<std::pair<const char*, const char*>>{
             {"world.start_of_episode", "task.on_start_of_episode"},
             {"world.start_of_episode", "learner.start_of_episode"},
             {"learner.start_of_action", "world.start_of_action"},
             {"learner.start_of_action", "task.on_start_of_action"},
             {"learner.execute", "world.execute"},
             {"world.end_of_time_step", "task.on_end_of_time_step"},
             {"world.end_of_action", "task.on_end_of_action"},
             {"world.end_of_action", "world.on_end_of_action"},
             {"world.end_of_action", "learner.end_of_action"},
             {"world.end_of_episode", "learner.end_of_episode"},
             {"task.reward", "world.pay"},
             {"task.reward", "learner.reward"},
             {"task.end_of_episode", "learner.end_of_episode"},
             {"learner.episode_over", "task.on_end_of_episode"},
             {"world.base.position", "task.base.position"},
             {"world.features", "learner.features"},
             {"world.action_count", "learner.action_count"}})
      graph_.Connect(from, to);
    task_->Set("pull", pull);
    learner_->Set("episode_end", std::string(episode_end));
    learner_->Set("temperature", 1.0);
    learner_->Set("temperature_decay", 0.02);
    graph_.Start();
    FindTaskModules(graph_, *learner_);
  }

  // How many actions it took.
  int PlayEpisode() {
    world_->StartEpisode();
    while (!learner_->episode_over()) world_->Move();
    return learner_->action_count();
  }
  // The actions of an episode after so many.
  int Learn() {
    for (int episode = 0; episode < 600; ++episode) PlayEpisode();
    return PlayEpisode();
  }
  double Value(int place, int action) const { return learner_->q_lambda().theta()(action, place); }

  // What the actions of the last episode brought, discounted as the learner does.
  double DiscountedSum() const {
    double sum = 0;
    double power = 1;
    for (const double paid : world_->paid) {
      sum += power * paid;
      power *= learner_->discount();
    }
    return sum;
  }

  Row& world() { return *world_; }
  UniversalTask& task() { return *task_; }
  PengQLambda& learner() { return *learner_; }

 private:
  robot::RobotDescription robot_;
  Context context_;
  ModuleGraph graph_;
  Row* world_ = nullptr;
  UniversalTask* task_ = nullptr;
  PengQLambda* learner_ = nullptr;
};

// With gamma = 0.9, staying at the left end is worth 0.5, and going right 0.729 from there.
TEST(Potential, LeavesTheBestPolicyTheBest) {
  for (const char* mode : {"immediate", "after_action"}) {
    EXPECT_EQ(Chain("chain", 0, mode).Learn(), 4) << mode;
    EXPECT_EQ(Chain("chain", 1, mode).Learn(), 4) << mode;
  }
}

TEST(Potential, AnotherRewardOfItsShapeDoesNot) {
  EXPECT_EQ(Chain("lured_chain", 0).Learn(), 4);
  EXPECT_EQ(Chain("lured_chain", 1).Learn(), 30);
}

// phi of a place is 1 - place, and what is learned with it is what is learned without, less phi.
TEST(Potential, ShiftsTheValuesByItself) {
  Chain chain("chain", 1);
  chain.Learn();
  const double best[] = {0.729, 0.81, 0.9, 1};
  for (int place = 0; place < 4; ++place)
    EXPECT_NEAR(chain.Value(place, 1), best[place] - (1 - place), 0.05) << place;
}

// A task that pays nothing but a potential, which is 7 in place 0.
class BarePotential : public testing::TestWithParam<const char*> {
 protected:
  BarePotential() {
    chain_.task().Set("stay_reward", 0.0);
    chain_.task().Set("arrival_reward", 0.0);
    chain_.learner().Set("temperature", 1e9);  // at random
  }

  // What the potential adds to the discounted sum of the episode that is over.
  double ExpectedSum() {
    const bool is_terminal = chain_.learner().episode_end().kind != EndKind::kTruncated;
    const double power = std::pow(chain_.learner().discount(), chain_.learner().action_count());
    return (is_terminal ? 0 : power * 7 * (1 - chain_.world().place())) - 7;
  }

  Chain chain_{"chain", 7, GetParam()};
};

TEST_P(BarePotential, PaysForAnEpisodeByItsTwoEnds) {
  int terminal = 0;
  for (int episode = 0; episode < 40; ++episode) {
    chain_.PlayEpisode();
    EXPECT_NEAR(chain_.DiscountedSum(), ExpectedSum(), 1e-12);
    terminal += chain_.learner().episode_end().kind == EndKind::kSuccess ? 1 : 0;
  }
  EXPECT_GT(terminal, 0);
  EXPECT_LT(terminal, 40);
}

TEST_P(BarePotential, GoesByTheEndThatTheLearnerHears) {
  for (const EndKind kind : {EndKind::kFailure, EndKind::kSuccess, EndKind::kTruncated}) {
    chain_.world().StartEpisode();
    chain_.world().Move();
    chain_.world().Move();
    chain_.world().EndEpisode({kind, "another's"});
    if (!chain_.learner().episode_over()) chain_.world().Move();
    ASSERT_TRUE(chain_.learner().episode_over());
    EXPECT_NEAR(chain_.DiscountedSum(), ExpectedSum(), 1e-12);
  }
}

// Such an end comes when the action has been paid for.
TEST_P(BarePotential, AnActionThatEndsWithTheEpisodeIsPaidForOnce) {
  for (const EndKind kind : {EndKind::kFailure, EndKind::kTruncated}) {
    chain_.world().end_with_action = EpisodeEnd{kind, "another's"};
    chain_.world().StartEpisode();
    chain_.world().Move();
    ASSERT_TRUE(chain_.learner().episode_over());
    EXPECT_NEAR(chain_.DiscountedSum(), ExpectedSum(), 1e-12);
  }
}

TEST_P(BarePotential, FollowsTheLearnersDiscount) {
  chain_.world().StartEpisode();
  chain_.learner().Set("discount", 0.5);
  chain_.world().Move();
  EXPECT_EQ(chain_.world().paid[0], 0.5 * 7 * (1 - chain_.world().place()) - 7);
}

INSTANTIATE_TEST_SUITE_P(Ends, BarePotential, testing::Values("immediate", "after_action"));

}  // namespace
}  // namespace runtime
