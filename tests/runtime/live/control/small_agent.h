// An agent that learns nothing worth knowing, but quickly.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/core/module/connections.h"
#include "runtime/core/task/universal_task.h"
#include "runtime/live/control/live_graph.h"
#include "runtime/training/learning/peng_q_lambda.h"
#include "runtime/training/simulation/robot_environment.h"

namespace runtime {

inline std::filesystem::path PluginFile(const std::string& name) {
  return std::filesystem::path(PLUGIN_FOLDER) / (name + ".so");
}

inline std::unique_ptr<TaskInstance> Instance(const std::string& plugin, int64_t id) {
  return std::make_unique<TaskInstance>(std::make_shared<const Plugin>(PluginFile(plugin)), id);
}

// State, features and action space in one: two actions, each of which does nothing for a while.
class Mind : public Module {
 public:
  Mind(std::string name, const Context&) : Module(std::move(name)) {
    AddParameter({.name = "steps", .doc = "of an action", .target = &steps_, .minimum = 1});
    AddParameter({.name = "pace", .doc = "", .target = &pace_, .minimum = 0, .unit = "m/s"});
    AddParameter({.name = "mood", .doc = "", .target = &mood_, .choices = {"calm", "wild"}});
    AddParameter({.name = "strict", .doc = "", .target = &strict_});
    AddParameter({.name = "weights", .doc = "", .target = &weights_, .maximum = 1});
    AddParameter({.name = "size", .doc = "", .target = &size_, .is_live = false});
  }

 private:
  void Execute(int) { left_ = steps_; }
  void EndTimeStep(double) {
    if (--left_ == 0) end_of_action_();
  }

  int steps_ = 4;
  double pace_ = 0.5;
  std::string mood_ = "calm";
  bool strict_ = false;
  std::vector<double> weights_ = {0.5};
  int64_t size_ = 1;
  int left_ = 0;
  int actions_ = 2;
  Eigen::VectorXd vector_ = Eigen::VectorXd::Constant(1, 1.0);

  Out<Eigen::VectorXd> features_{this, "features", &vector_};
  Out<int> action_count_{this, "action_count", &actions_};
  Slot<int> execute_{this, "execute", Bind<&Mind::Execute>{}};
  Slot<double> end_of_time_step_{this, "on_end_of_time_step", Bind<&Mind::EndTimeStep>{}};
  Signal<> end_of_action_{this, "end_of_action"};
};

// Needs a vector before it can start.
class Reader : public Module {
 public:
  Reader(std::string name, const Context&) : Module(std::move(name)) {
    AddParameter({.name = "count", .doc = "", .target = &count_, .maximum = 9});
  }
  void Start() override { RequireConnections(*this); }

 private:
  void Ignore(double) {}

  int count_ = 2;
  Eigen::VectorXd vector_ = Eigen::VectorXd::Constant(1, 1.0);
  In<Eigen::VectorXd> in_{this, "in"};
  Out<Eigen::VectorXd> out_{this, "out", &vector_};
  Slot<double> note_{this, "note", Bind<&Reader::Ignore>{}};
};

// Shows a learner what a task observes.
class Viewer : public Module {
 public:
  Viewer(std::string name, const Context&) : Module(std::move(name)) {}

 private:
  In<TaskObservations> task_{this, "task"};
};

class SmallAgent {
 public:
  SmallAgent() {
    types_.Add<RobotEnvironment>("RobotEnvironment");
    types_.Add<UniversalTask>("UniversalTask");
    types_.Add<PengQLambda>("PengQLambda");
    types_.Add<Mind>("Mind");
    types_.Add<Reader>("Reader");
    types_.Add<Viewer>("Viewer");
    for (const auto& [type, name] : {std::pair{"RobotEnvironment", "environment"},
                                     {"UniversalTask", "task"},
                                     {"Mind", "mind"},
                                     {"PengQLambda", "learner"}}) {
      graph_.Add(types_.Make(type, name, context_));
    }
    graph_.Find("environment").Set("profile", std::string("fast"));
    for (const auto& [first, second] : kConnections) graph_.Connect(first, second);
    graph_.Start();
  }

  const robot::RobotDescription& robot() const { return robot_; }
  const ModuleTypes& types() const { return types_; }
  const Context& context() const { return context_; }
  ModuleGraph& graph() { return graph_; }

 private:
  static constexpr std::pair<const char*, const char*> kConnections[] = {
      {"environment.start_of_episode", "task.on_start_of_episode"},
      {"environment.start_of_episode", "learner.start_of_episode"},
      {"learner.start_of_action", "task.on_start_of_action"},
      {"learner.execute", "mind.execute"},
      {"environment.end_of_time_step", "task.on_end_of_time_step"},
      {"environment.end_of_time_step", "mind.on_end_of_time_step"},
      {"mind.end_of_action", "task.on_end_of_action"},
      {"mind.end_of_action", "learner.end_of_action"},
      {"task.reward", "learner.reward"},
      {"task.end_of_episode", "learner.end_of_episode"},
      {"environment.end_of_episode", "learner.end_of_episode"},
      {"learner.episode_over", "task.on_end_of_episode"},
      {"environment.*", "task.*"},
      {"mind.features", "learner.features"},
      {"mind.action_count", "learner.action_count"},
  };

  robot::RobotDescription robot_ = robot::ReadRobot(HOPPER);
  ModuleTypes types_;
  Context context_{&robot_, std::make_shared<const Plugin>(PluginFile("steady")), 1};
  ModuleGraph graph_;
};

}  // namespace runtime
