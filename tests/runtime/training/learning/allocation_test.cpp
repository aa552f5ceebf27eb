// The whole agent, connected by name as an agent file does it, and what it costs: no allocation per
// time step nor per action.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>

#include "runtime/core/module/module_graph.h"
#include "runtime/training/learning/joint_offsets.h"
#include "runtime/training/learning/module_types.h"
#include "runtime/training/learning/peng_q_lambda.h"
#include "runtime/training/learning/ppo.h"
#include "tests/runtime/training/learning/continuous_world.h"
#include "tests/runtime/training/learning/fake_sensors.h"
#include "tests/runtime/training/learning/fake_world.h"
#include "tests/runtime/training/learning/time_step.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define COUNTS_ALLOCATIONS 0
#else
#define COUNTS_ALLOCATIONS 1
#endif

namespace {
std::atomic<int64_t> allocations = 0;
}

#if COUNTS_ALLOCATIONS
extern "C" void* __libc_malloc(size_t size);
extern "C" void* malloc(size_t size) {
  ++allocations;
  return __libc_malloc(size);
}
#endif

namespace runtime {
namespace {

// An environment whose joints go a tenth of the way to their targets in each time step.
class Puppet : public FakeSensorModule {
 public:
  Puppet() : FakeSensorModule(&sensors) {}

  void RunTimeStep() {
    start_of_time_step(kTimeStep);
    for (int j = 0; j < 17; ++j) {
      const double change = 0.1 * (joint_targets()[j] - sensors.joint_angle[j]);
      sensors.joint_angle[j] += change;
      sensors.joint_velocity[j] = change / kTimeStep;
    }
    reward(sensors.joint_angle[8]);
    end_of_time_step(kTimeStep);
  }

  FakeSensors sensors;
  Signal<> start_of_episode{this, "start_of_episode"};
  Signal<double> start_of_time_step{this, "start_of_time_step"};
  Signal<double> end_of_time_step{this, "end_of_time_step"};
  Signal<double> reward{this, "reward"};
  Signal<EpisodeEnd> end_of_episode{this, "end_of_episode"};
  In<Eigen::VectorXd> joint_targets{this, "joint_targets"};
};

class Agent {
 public:
  Agent() {
    AddLearningModules(types_);
    puppet_ = static_cast<Puppet*>(&graph_.Add(std::make_unique<Puppet>()));
    // In the reverse of the natural order, which must not matter.
    for (const auto& [name, type] : {std::pair{"learner", "PengQLambda"},
                                     {"action_space", "Dcob"},
                                     {"features", "NgNet"},
                                     {"state", "DofState"}}) {
      graph_.Add(types_.Make(type, name, HumanoidContext()));
    }
    for (const auto& [from, to] :
         {std::pair{"environment.*", "state.*"},
          {"state.state", "features.state"},
          {"state.state", "action_space.state"},
          {"features.features", "action_space.features"},
          {"features.features", "learner.features"},
          {"features.net", "action_space.net"},
          {"action_space.joint_targets", "environment.joint_targets"},
          {"action_space.action_count", "learner.action_count"},
          {"environment.start_of_episode", "learner.start_of_episode"},
          {"learner.execute", "action_space.execute"},
          {"environment.start_of_time_step", "action_space.start_of_time_step"},
          {"environment.end_of_time_step", "action_space.end_of_time_step"},
          {"action_space.end_of_action", "learner.end_of_action"},
          {"environment.reward", "learner.reward"},
          {"environment.end_of_episode", "learner.end_of_episode"}}) {
      graph_.Connect(from, to);
    }
    graph_.Start();
  }

  Puppet& puppet() { return *puppet_; }
  const PengQLambda& learner() { return graph_.FindAs<PengQLambda>("learner"); }

 private:
  ModuleTypes types_;
  ModuleGraph graph_;
  Puppet* puppet_;
};

TEST(Agent, ActsAndLearnsThroughItsConnections) {
  Agent agent;
  agent.puppet().start_of_episode();
  for (int step = 0; step < 2000; ++step) agent.puppet().RunTimeStep();
  EXPECT_GT(agent.learner().action_count(), 40);  // published: 31 time steps on average
  EXPECT_LT(agent.learner().action_count(), 160);
  EXPECT_FALSE(agent.learner().q_lambda().theta().isZero());
  EXPECT_EQ(agent.puppet().joint_targets()[8], agent.puppet().joint_targets()[13]);

  agent.puppet().end_of_episode(kTimeIsUp);
  for (int step = 0; step < 100; ++step) agent.puppet().RunTimeStep();
  EXPECT_TRUE(agent.learner().episode_over());
}

TEST(Agent, AllocatesNothingPerStepNorPerAction) {
  if (!COUNTS_ALLOCATIONS) GTEST_SKIP() << "a sanitizer has its own malloc";
  Agent agent;
  agent.puppet().start_of_episode();
  for (int step = 0; step < 200; ++step) agent.puppet().RunTimeStep();
  const int actions_before = agent.learner().action_count();
  const int64_t before = allocations;
  for (int step = 0; step < 1000; ++step) agent.puppet().RunTimeStep();
  const int64_t after = allocations;
  EXPECT_EQ(after - before, 0);
  EXPECT_GT(agent.learner().action_count(), actions_before + 10);

  const auto probe = std::make_unique<int>(1);  // the count counts
  EXPECT_GT(allocations, after);
  EXPECT_EQ(*probe, 1);
}

// The same of PPO and its action space; the batch grows where it was never as large before.
TEST(Ppo, AllocatesNothingPerStepNorPerAction) {
  if (!COUNTS_ALLOCATIONS) GTEST_SKIP() << "a sanitizer has its own malloc";
  ContinuousWorld world(79, 17);
  JointOffsets action_space("action_space", HumanoidContext());
  Ppo learner("learner", HumanoidContext());
  Signal<double> end_of_time_step(&world, "end_of_time_step");
  for (const char* port : {"observation", "start_of_episode", "reward", "end_of_episode"}) {
    Connect(world, port, learner, port);
  }
  Connect(action_space, "action_size", learner, "action_size");
  Connect(learner, "execute", action_space, "execute");
  Connect(action_space, "end_of_action", learner, "end_of_action");
  Connect(world, "end_of_time_step", action_space, "end_of_time_step");
  action_space.Start();
  learner.Start();
  const auto run_episode = [&](int steps) {
    world.start_of_episode();
    int64_t before = 0;
    for (int step = 0; step < steps; ++step) {
      if (step == 50) before = allocations;  // after the first actions
      world.observation[step % 79] += 0.1;
      world.reward(0.1);
      end_of_time_step(kTimeStep);
    }
    const int64_t count = allocations - before;
    world.end_of_episode(kTimeIsUp);
    return count;
  };
  run_episode(4000);
  EXPECT_EQ(run_episode(4000), 0);
  EXPECT_EQ(learner.state().batch.decisions(), 1002);
}

}  // namespace
}  // namespace runtime
