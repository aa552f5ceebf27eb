#pragma once

#include "runtime/core/module/module.h"
#include "runtime/core/module/values.h"
#include "runtime/training/learning/learner.h"
#include "tests/runtime/training/learning/fake_state.h"
#include "tests/runtime/training/learning/fake_world.h"

namespace runtime {

// Environment, task and action space in one of a learner whose actions are vectors, played by the
// test.
class ContinuousWorld : public Module {
 public:
  ContinuousWorld(int observation_size, int action_size)
      : Module("world"),
        observation(Eigen::VectorXd::Zero(observation_size)),
        action_size_(action_size) {}

  void ConnectTo(Learner& learner) {
    for (const char* port : {"observation", "action_size", "start_of_episode", "reward",
                             "end_of_action", "end_of_episode"}) {
      Connect(*this, port, learner, port);
    }
    Connect(learner, "execute", *this, "execute");
  }

  // One action that brings `amount`.
  void PlayAction(double amount) {
    reward(amount);
    end_of_action();
  }

  Eigen::VectorXd observation;
  Eigen::VectorXd action;

 private:
  void Execute(const Eigen::VectorXd& chosen) { action = chosen; }

  int action_size_;
  Out<Eigen::VectorXd> observation_out_{this, "observation", &observation};
  Out<int> action_size_out_{this, "action_size", &action_size_};
  Slot<const Eigen::VectorXd&> execute_{this, "execute", Bind<&ContinuousWorld::Execute>{}};

 public:
  Signal<> start_of_episode{this, "start_of_episode"};
  Signal<double> reward{this, "reward"};
  Signal<EpisodeEnd> end_of_episode{this, "end_of_episode"};
  Signal<> end_of_action{this, "end_of_action"};
};

}  // namespace runtime
