#pragma once

#include <functional>
#include <string>
#include <vector>

#include "runtime/core/module/module.h"
#include "runtime/core/module/values.h"
#include "runtime/training/learning/peng_q_lambda.h"
#include "tests/runtime/training/learning/fake_state.h"

namespace runtime {

// Environment, task and action space of a learner in one, played by the test. Notes what it is
// told.
class FakeWorld : public Module {
 public:
  FakeWorld(int actions, int features_count)
      : Module("world"),
        features(Eigen::VectorXd::Constant(features_count, 1.0 / features_count)),
        actions_(actions) {}

  void ConnectTo(PengQLambda& learner) {
    for (const char* port : {"features", "action_count", "start_of_episode", "reward",
                             "end_of_action", "end_of_episode"}) {
      Connect(*this, port, learner, port);
    }
    Connect(learner, "start_of_action", *this, "on_start_of_action");
    Connect(learner, "execute", *this, "execute");
    Connect(learner, "episode_over", *this, "on_episode_over");
  }

  // One action that brings `amount`.
  void PlayAction(double amount) {
    reward(amount);
    end_of_action();
  }

  Eigen::VectorXd features;
  std::vector<std::string> told;
  int action = -1;
  std::function<void()> at_start_of_action = [] {};
  std::function<void()> at_episode_over = [] {};

 private:
  void OnStartOfAction() {
    told.push_back("start_of_action");
    at_start_of_action();
  }
  void Execute(int chosen) {
    told.push_back("execute");
    action = chosen;
  }
  void OnEpisodeOver(EpisodeEnd end) {
    told.push_back(std::string("episode_over: ") + end.reason);
    at_episode_over();
  }

  int actions_;
  Out<Eigen::VectorXd> features_out_{this, "features", &features};
  Out<int> action_count_{this, "action_count", &actions_};
  Slot<> on_start_of_action_{this, "on_start_of_action", Bind<&FakeWorld::OnStartOfAction>{}};
  Slot<int> execute_{this, "execute", Bind<&FakeWorld::Execute>{}};
  Slot<EpisodeEnd> on_episode_over_{this, "on_episode_over", Bind<&FakeWorld::OnEpisodeOver>{}};

 public:
  Signal<> start_of_episode{this, "start_of_episode"};
  Signal<double> reward{this, "reward"};
  Signal<EpisodeEnd> end_of_episode{this, "end_of_episode"};
  Signal<> end_of_action{this, "end_of_action"};
};

inline constexpr EpisodeEnd kGoal{EndKind::kSuccess, "goal"};
inline constexpr EpisodeEnd kFall{EndKind::kFailure, "fall"};
inline constexpr EpisodeEnd kTimeIsUp{EndKind::kTruncated, "time is up"};
inline constexpr EpisodeEnd kBlownUp{EndKind::kDiverged, "blown up"};

}  // namespace runtime
