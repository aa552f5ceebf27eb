// What environments without a robot are learned with: features of an observation, and actions that
// are vectors.
#include <gmock/gmock.h>

#include <functional>
#include <string>
#include <vector>

#include "runtime/core/module/module_graph.h"
#include "runtime/training/learning/action_table.h"
#include "runtime/training/learning/box_actions.h"
#include "runtime/training/learning/grid_features.h"
#include "runtime/training/learning/point_dcob.h"

namespace runtime {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;

const robot::RobotDescription kNoRobot;
const Context kContext{&kNoRobot, {}, 0};

// What the modules read, and what they send.
class World : public Module {
 public:
  World() : Module("world") {}

  Eigen::VectorXd observation = Eigen::VectorXd::Zero(2);
  ActionLimits limits{Eigen::Vector2d(-1, 0), Eigen::Vector2d(1, 10)};
  int ended = 0;

  Signal<int> execute_index{this, "execute_index"};
  Signal<const Eigen::VectorXd&> execute_vector{this, "execute_vector"};
  Signal<double> start_of_time_step{this, "start_of_time_step"};
  Signal<double> end_of_time_step{this, "end_of_time_step"};
  In<Eigen::VectorXd> action{this, "action"};

 private:
  void End() { ++ended; }
  Out<Eigen::VectorXd> observation_{this, "observation", &observation};
  Out<ActionLimits> limits_{this, "limits", &limits};
  Slot<> end_{this, "end_of_action", Bind<&World::End>{}};
};

class WorldModules : public testing::Test {
 protected:
  WorldModules() : world_(static_cast<World&>(graph_.Add(std::make_unique<World>()))) {}

  template <class M>
  M& Add(const std::string& name) {
    return static_cast<M&>(graph_.Add(std::make_unique<M>(name, kContext)));
  }
  template <class M>
  M& AddActions() {
    M& actions = Add<M>("actions");
    graph_.Connect("world.limits", "actions.limits");
    graph_.Connect("world.end_of_time_step", "actions.end_of_time_step");
    graph_.Connect("actions.action", "world.action");
    graph_.Connect("actions.end_of_action", "world.end_of_action");
    return actions;
  }
  GridFeatures& AddFeatures(std::vector<double> counts) {
    auto& features = Add<GridFeatures>("features");
    features.Set("counts", std::move(counts));
    features.Set("low", std::vector{0.0, 0.0});
    features.Set("high", std::vector{9.0, 1.0});
    graph_.Connect("world.observation", "features.observation");
    return features;
  }
  const Eigen::VectorXd& Features() {
    return dynamic_cast<Out<Eigen::VectorXd>&>(graph_.FindPort("features.features"))();
  }
  // Where a table has its 1.
  Eigen::Index EntryAt(double x, double y) {
    world_.observation << x, y;
    Eigen::Index entry = 0;
    EXPECT_EQ(Features().sum(), 1);
    EXPECT_EQ(Features().maxCoeff(&entry), 1);
    return entry;
  }
  static std::string Refusal(const std::function<void()>& action) {
    try {
      action();
    } catch (const UserError& error) {
      return error.what();
    }
    return "nothing was refused";
  }

  ModuleGraph graph_;
  World& world_;
};

TEST_F(WorldModules, ATableHasAnEntryForEachPoint) {
  AddFeatures({10, 2}).Set("kind", std::string("table"));
  graph_.Start();
  EXPECT_EQ(EntryAt(0, 0), 0);
  EXPECT_EQ(EntryAt(3, 0), 3);
  EXPECT_EQ(EntryAt(3.4, 0.4), 3);
  EXPECT_EQ(EntryAt(3.6, 0.6), 14);
  EXPECT_EQ(EntryAt(9, 1), 19);
  EXPECT_EQ(EntryAt(-5, 100), 10);  // the nearest one
}

TEST_F(WorldModules, SmoothFeaturesAreThoseOfTheNet) {
  AddFeatures({4, 2});
  graph_.Start();
  world_.observation << 3, 0;
  const Eigen::VectorXd& features = Features();
  ASSERT_EQ(features.size(), 8);
  EXPECT_THAT(features.sum(), DoubleNear(1, 1e-12));
  EXPECT_GT(features[1], 0.9);
}

TEST_F(WorldModules, WrongGridsAreRefused) {
  auto& features = AddFeatures({10, 2});
  const auto refusal = [&] { return Refusal([&] { features.Start(); }); };
  features.Set("low", std::vector{0.0});
  EXPECT_THAT(refusal(), HasSubstr("need a number for each element of the observation"));
  features.Set("low", std::vector{0.0, 2.0});
  EXPECT_THAT(refusal(), HasSubstr("`features.low` has 2, above the 1 of `features.high`"));
  features.Set("low", std::vector{0.0, 0.0});
  features.Set("counts", std::vector{2.5, 2.0});
  EXPECT_THAT(refusal(), HasSubstr("2.5 is not whole"));
  features.Set("counts", std::vector{1e4, 1e4});
  EXPECT_THAT(refusal(), HasSubstr("has 1e+08 points, more than 100000"));
  features.Set("counts", std::vector{10.0, 2.0});
  features.Start();
  world_.observation.setZero(3);
  EXPECT_THAT(Refusal([&] { Features(); }), HasSubstr("gets an observation of 3 elements"));
}

TEST_F(WorldModules, AnActionOfATableIsHeld) {
  auto& table = AddActions<ActionTable>();
  graph_.Connect("world.execute_index", "actions.execute");
  table.Set("actions", std::vector{1.0, 2.0, 3.0, 4.0, 5.0, 6.0});
  table.Set("hold", int64_t{2});
  graph_.Start();
  world_.execute_index(1);
  EXPECT_THAT(world_.action(), ElementsAre(3, 4));
  world_.end_of_time_step(0.1);
  EXPECT_EQ(world_.ended, 0);
  world_.end_of_time_step(0.1);
  EXPECT_EQ(world_.ended, 1);
  world_.end_of_time_step(0.1);
  EXPECT_EQ(world_.ended, 1);
  EXPECT_THAT(Refusal([&] { world_.execute_index(3); }), HasSubstr("gets action 3 and has 3"));
}

TEST_F(WorldModules, ATableNeedsVectorsOfTheEnvironmentsSize) {
  auto& table = AddActions<ActionTable>();
  EXPECT_THAT(Refusal([&] { table.Start(); }), HasSubstr("`actions.actions` has 0 numbers"));
  table.Set("actions", std::vector{1.0, 2.0, 3.0});
  EXPECT_THAT(Refusal([&] { table.Start(); }),
              HasSubstr("has 3 numbers, and an action of the environment has 2"));
}

TEST_F(WorldModules, ABoxIsFrom1To1) {
  AddActions<BoxActions>();
  graph_.Connect("world.execute_vector", "actions.execute");
  graph_.Start();
  const auto commanded = [&](double first, double second) {
    world_.execute_vector(Eigen::VectorXd(Eigen::Vector2d(first, second)));
    return world_.action();
  };
  EXPECT_THAT(commanded(0, 0), ElementsAre(0, 5));
  EXPECT_THAT(commanded(-1, 1), ElementsAre(-1, 10));
  EXPECT_THAT(commanded(7, -7), ElementsAre(1, 0));
  world_.end_of_time_step(0.1);
  EXPECT_EQ(world_.ended, 1);
  EXPECT_THAT(Refusal([&] { world_.execute_vector(Eigen::VectorXd::Zero(3)); }),
              HasSubstr("gets an action of 3 elements, and its actions have 2"));
}

class PointDcobTest : public WorldModules {
 protected:
  PointDcobTest() {
    AddFeatures({4, 2});
    dcob_ = &AddActions<PointDcob>();
    dcob_->Set("abbreviation_scale", 10.0);  // no motion is cut short
    graph_.Connect("world.observation", "actions.observation");
    graph_.Connect("features.features", "actions.features");
    graph_.Connect("features.net", "actions.net");
    graph_.Connect("world.execute_index", "actions.execute");
    graph_.Connect("world.start_of_time_step", "actions.start_of_time_step");
  }

  PointDcob* dcob_;
};

// (1 - (1 - t / T)^3) of the way, as of the start of each time step.
TEST_F(PointDcobTest, TheWayIsThatOfDcob) {
  dcob_->Set("intervals", std::vector{0.1});
  dcob_->Set("command", std::string("position"));
  graph_.Start();
  world_.execute_index(1);  // the unit at (3, 0): T = 0.3 s
  world_.start_of_time_step(0.1);
  EXPECT_THAT(world_.action(), ElementsAre(0, 0));
  world_.end_of_time_step(0.1);
  world_.start_of_time_step(0.1);
  EXPECT_THAT(world_.action()[0], DoubleNear(3 * (1 - 8. / 27), 1e-12));
}

TEST_F(PointDcobTest, ADisplacementIsFromWhereThePointIs) {
  dcob_->Set("intervals", std::vector{0.1});
  graph_.Start();
  world_.execute_index(1);
  world_.start_of_time_step(0.1);
  world_.end_of_time_step(0.1);
  world_.observation[0] = 2;
  world_.start_of_time_step(0.1);
  EXPECT_THAT(world_.action()[0], DoubleNear(3 * (1 - 8. / 27) - 2, 1e-12));
}

TEST_F(PointDcobTest, WhatIsObservedHasToBeWhatMoves) {
  world_.limits = {Eigen::VectorXd::Zero(1), Eigen::VectorXd::Ones(1)};
  EXPECT_THAT(Refusal([&] { graph_.Start(); }),
              HasSubstr("a net over 2 elements, and an action of the environment has 1"));
}

}  // namespace
}  // namespace runtime
