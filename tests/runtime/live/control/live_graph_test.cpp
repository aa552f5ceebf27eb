#include "runtime/live/control/live_graph.h"

#include <gmock/gmock.h>

#include "runtime/core/module/graph_text.h"
#include "tests/runtime/live/control/small_agent.h"
#include "tests/runtime/training/run/error_of.h"

namespace runtime {
namespace {

using testing::ElementsAre;

class LiveGraphTest : public testing::Test {
 protected:
  Port& PortNamed(const char* name) { return agent_.graph().FindPort(name); }
  std::vector<std::string> ConnectionsOf(const char* port) {
    std::vector<std::string> names;
    for (const Port* other : PortNamed(port).Connections()) names.push_back(other->full_name());
    return names;
  }
  // Modules, parameters, and connections in their order.
  std::string Everything() {
    std::string text = GraphText(agent_.graph());
    for (const auto& module : agent_.graph().modules()) {
      for (const Port* port : module->ports()) {
        for (const Port* other : port->Connections()) {
          text += port->full_name() + " " + other->full_name() + "\n";
        }
      }
      for (const Parameter& parameter : module->parameters()) {
        text += parameter.name + " = " + ToText(module->Get(parameter.name)) + "\n";
      }
    }
    return text;
  }
  // What `action` complains about; it must have changed nothing then.
  template <class Action>
  std::string Refusal(Action action) {
    const std::string before = Everything();
    const std::string error = ErrorOf(action);
    EXPECT_EQ(Everything(), before);
    return error;
  }

  SmallAgent agent_;
  LiveGraph live_{agent_.graph(), agent_.types(), agent_.context()};
};

TEST_F(LiveGraphTest, AShadowHearsOfEverythingRightAfterTheActiveTask) {
  live_.Load("shadow", Instance("other", 2));
  EXPECT_THAT(ConnectionsOf("environment.start_of_episode"),
              ElementsAre("task.on_start_of_episode", "shadow.on_start_of_episode",
                          "learner.start_of_episode"));
  EXPECT_THAT(ConnectionsOf("environment.end_of_time_step"),
              ElementsAre("task.on_end_of_time_step", "shadow.on_end_of_time_step",
                          "mind.on_end_of_time_step"));
  EXPECT_THAT(
      ConnectionsOf("mind.end_of_action"),
      ElementsAre("task.on_end_of_action", "shadow.on_end_of_action", "learner.end_of_action"));
  EXPECT_THAT(ConnectionsOf("shadow.time"), ElementsAre("environment.time"));
  EXPECT_THAT(ConnectionsOf("shadow.reward"), ElementsAre());
  EXPECT_EQ(live_.active_task().name(), "task");
  EXPECT_TRUE(live_.FindTask("shadow").is_shadow());
}

TEST_F(LiveGraphTest, AShadowThatDoesNotFitIsNotLoaded) {
  EXPECT_EQ(Refusal([&] { live_.Load("mind", Instance("other", 2)); }),
            "there is a module `mind` already");
  EXPECT_EQ(Refusal([&] { live_.Load("a.b", Instance("other", 2)); }),
            "`a.b` cannot name a module: a name has no '.'");
  EXPECT_EQ(Refusal([&] { live_.Load("", Instance("other", 2)); }), "a module needs a name");
  EXPECT_EQ(Refusal([&] { live_.Load("shadow", Instance("for_snake", 2)); }),
            "test.task: the task `test` is for the robot `snake`, and this run has the robot "
            "`hopper`");
}

TEST_F(LiveGraphTest, ALearnerGoesOnSeeingWhatItHasLearnedFrom) {
  agent_.graph().Add(agent_.types().Make("Viewer", "viewer", agent_.context()));
  agent_.graph().Connect("task.observations", "viewer.task");
  const std::string refusal =
      "the learner cannot go on with the task `seeing`: it would see `elapsed` (real [s]) instead "
      "of what the robot senses; train it in a run of its own";
  EXPECT_EQ(Refusal([&] { live_.Swap("task", Instance("seeing", 2)); }), refusal);
  live_.Load("shadow", Instance("seeing", 2));
  EXPECT_EQ(Refusal([&] { live_.Promote("shadow"); }), refusal);
  EXPECT_EQ(Refusal([&] { live_.Connect("shadow.observations", "viewer.task"); }), refusal);
  live_.Load("same", Instance("other", 3));
  live_.Promote("same");
  EXPECT_THAT(ConnectionsOf("viewer.task"), ElementsAre("same.observations"));
  // What nobody sees may be anything.
  live_.Swap("task", Instance("seeing", 2));
}

// Ports have dots in their names, and so it must not matter what comes before the first one.
TEST_F(LiveGraphTest, AShadowMayHaveTheNameOfASensor) {
  live_.Load("base", Instance("other", 2));
  live_.Set("base.gain", 2.0);
  EXPECT_EQ(live_.Get("base.gain"), ParameterValue(2.0));
  EXPECT_THAT(ErrorOf([&] { live_.Connect("base.velocity", "task.reward"); }),
              testing::StartsWith("the module `base` has no port `velocity`"));
  live_.Unload("base");
}

TEST_F(LiveGraphTest, OnlyShadowsCanBeUnloaded) {
  EXPECT_EQ(Refusal([&] { live_.Unload("task"); }),
            "`task` is the active task: promote another one first, or swap it");
  EXPECT_EQ(Refusal([&] { live_.Unload("mind"); }),
            "there is no task module `mind`; there is only `task`");
  const std::string before = Everything();
  live_.Load("shadow", Instance("other", 2));
  live_.Unload("shadow");
  EXPECT_EQ(Everything(), before);
}

TEST_F(LiveGraphTest, ASwapThatDoesNotFitChangesNothing) {
  EXPECT_EQ(Refusal([&] { live_.Swap("tusk", Instance("other", 2)); }),
            "there is no task module `tusk`: did you mean `task`?");
  EXPECT_EQ(Refusal([&] { live_.Swap("task", Instance("for_snake", 2)); }),
            "test.task: the task `test` is for the robot `snake`, and this run has the robot "
            "`hopper`");
  EXPECT_EQ(Refusal([&] { live_.Rollback("task"); }),
            "`task` has no previous task: it has not been swapped yet");
  live_.Swap("task", Instance("other", 2));
  EXPECT_STREQ(live_.active_task().plugin().name, "other");
  live_.Rollback("task");
  EXPECT_STREQ(live_.active_task().plugin().name, "steady");
}

TEST_F(LiveGraphTest, APromotedShadowPaysWhoeverTheActiveTaskPaid) {
  live_.AddModule("Reader", "reader", {});
  live_.Connect("mind.features", "reader.in");
  live_.Connect("task.reward", "reader.note");
  live_.Load("shadow", Instance("other", 2));
  EXPECT_NO_THROW(live_.CheckPromote("shadow", false));
  live_.Promote("shadow");
  EXPECT_EQ(live_.active_task().name(), "shadow");
  EXPECT_THAT(ConnectionsOf("shadow.reward"), ElementsAre("learner.reward", "reader.note"));
  EXPECT_THAT(ConnectionsOf("shadow.end_of_episode"), ElementsAre("learner.end_of_episode"));
  EXPECT_THAT(ConnectionsOf("task.reward"), ElementsAre());
  EXPECT_THAT(ConnectionsOf("task.end_of_episode"), ElementsAre());
  EXPECT_EQ(Refusal([&] { live_.Promote("shadow"); }), "`shadow` is active already");
  EXPECT_EQ(Refusal([&] { live_.CheckPromote("shadow", false); }), "`shadow` is active already");
}

// The learner would never hear of an end that the shadow has reached already.
TEST_F(LiveGraphTest, InAnEpisodeOnlyATaskThatCanStillEndItIsPromoted) {
  const std::string refusal =
      "for `shadow` this episode is over, or has never begun: promote it without `now`";
  auto& environment = agent_.graph().FindAs<RobotEnvironment>("environment");
  live_.Load("shadow", Instance("other", 2));
  live_.active_task();
  live_.Set("mind.steps", int64_t{10});
  live_.Set("shadow.limit", 0.012);
  EXPECT_EQ(ErrorOf([&] { live_.CheckPromote("shadow", true); }), refusal);
  environment.StartEpisode();
  environment.RunTimeStep();
  EXPECT_EQ(ErrorOf([&] { live_.CheckPromote("shadow", true); }), "");
  environment.RunTimeStep();
  environment.RunTimeStep();  // 15 ms: the shadow's end, which comes with the end of the action
  EXPECT_FALSE(live_.FindTask("shadow").has_ended());
  EXPECT_EQ(ErrorOf([&] { live_.CheckPromote("shadow", true); }), refusal);
  for (int i = 0; i < 10; ++i) environment.RunTimeStep();
  EXPECT_TRUE(live_.FindTask("shadow").has_ended());
  EXPECT_EQ(ErrorOf([&] { live_.CheckPromote("shadow", true); }), refusal);
  EXPECT_EQ(ErrorOf([&] { live_.CheckPromote("shadow", false); }), "");
}

TEST_F(LiveGraphTest, ParametersAreSetByTheirFullNames) {
  live_.Set("task.gain", 2.5);
  EXPECT_EQ(live_.Get("task.gain"), ParameterValue(2.5));
  live_.Set("mind.mood", std::string("wild"));
  EXPECT_EQ(live_.Get("mind.mood"), ParameterValue(std::string("wild")));
  EXPECT_EQ(Refusal([&] { live_.Set("task", 1.0); }),
            "`task` is not a parameter: write MODULE.PARAMETER");
  EXPECT_EQ(Refusal([&] { live_.Set("tusk.gain", 1.0); }),
            "there is no module `tusk`: did you mean `task`?");
  EXPECT_EQ(Refusal([&] { live_.Set("task.gian", 1.0); }),
            "the module `task` has no parameter `gian`: did you mean `gain`?");
  EXPECT_EQ(Refusal([&] { live_.Set("task.gain", 10.5); }),
            "`task.gain` must lie in 0 .. 10, and 10.5 does not");
  EXPECT_EQ(Refusal([&] { live_.Set("mind.mood", std::string("sad")); }),
            "`mind.mood` cannot be \"sad\"; there are `calm`, `wild`");
  EXPECT_EQ(Refusal([&] { live_.Set("mind.size", int64_t{2}); }),
            "`mind.size` has no effect any more: it is read when a run starts; set it in an agent "
            "file, or with `--set mind.size=...`, for another run");
}

TEST_F(LiveGraphTest, AnInPortGetsAnotherOutPort) {
  live_.AddModule("Reader", "reader", {});
  live_.Connect("reader.in", "mind.features");
  live_.Connect("reader.out", "learner.features");
  EXPECT_THAT(ConnectionsOf("learner.features"), ElementsAre("reader.out"));
  EXPECT_THAT(ConnectionsOf("mind.features"), ElementsAre("reader.in"));
  live_.Connect("learner.features", "mind.features");
  EXPECT_THAT(ConnectionsOf("learner.features"), ElementsAre("mind.features"));
}

TEST_F(LiveGraphTest, WhatDoesNotFitIsNotConnected) {
  EXPECT_EQ(Refusal([&] { live_.Connect("task.reward", "learner.end_of_action"); }),
            "cannot connect `task.reward` to `learner.end_of_action`: the types differ: "
            "`task.reward` is `(real)`, `learner.end_of_action` is `()`; `task.reward` fits "
            "`learner.reward`");
  EXPECT_EQ(Refusal([&] { live_.Connect("mind.action_count", "learner.features"); }),
            "cannot connect `mind.action_count` to `learner.features`: the types differ: "
            "`mind.action_count` is `int`, `learner.features` is `vector`; `mind.action_count` "
            "fits `learner.action_count`");
  EXPECT_EQ(Refusal([&] { live_.Connect("mind.features", "learner.features"); }),
            "cannot connect `mind.features` to `learner.features`: they are connected already");
  EXPECT_EQ(Refusal([&] { live_.Connect("mind", "learner.features"); }),
            "`mind` is not a port: write MODULE.PORT");
}

TEST_F(LiveGraphTest, SlotsAreDisconnectedAndConnectedAgain) {
  live_.Disconnect("task.on_end_of_action", "mind.end_of_action");
  EXPECT_THAT(ConnectionsOf("mind.end_of_action"), ElementsAre("learner.end_of_action"));
  EXPECT_EQ(Refusal([&] { live_.Disconnect("task.on_end_of_action", "mind.end_of_action"); }),
            "cannot disconnect `task.on_end_of_action` from `mind.end_of_action`: they are not "
            "connected");
  live_.Connect("task.on_end_of_action", "mind.end_of_action");
  EXPECT_THAT(ConnectionsOf("mind.end_of_action"),
              ElementsAre("learner.end_of_action", "task.on_end_of_action"));
}

TEST_F(LiveGraphTest, AnInPortThatIsReadKeepsItsValue) {
  EXPECT_EQ(Refusal([&] { live_.Disconnect("mind.features", "learner.features"); }),
            "`learner.features` must have a value: connect it to another out port of the type "
            "`vector` instead, which replaces this one");
  live_.Connect("mind.features", "environment.joint_targets");  // can do without
  live_.Disconnect("mind.features", "environment.joint_targets");
}

TEST_F(LiveGraphTest, TheLearnerIsAlwaysPaid) {
  live_.AddModule("Reader", "reader", {});
  live_.Connect("mind.features", "reader.in");
  live_.Connect("task.reward", "reader.note");
  EXPECT_EQ(Refusal([&] { live_.Disconnect("learner.reward", "task.reward"); }),
            "without `learner.reward` to `task.reward` no task pays the learner: promote another "
            "task module instead");
  EXPECT_THAT(ConnectionsOf("task.reward"), ElementsAre("learner.reward", "reader.note"));
  live_.Load("second", Instance("other", 2));
  live_.Connect("second.reward", "learner.reward");
  live_.Disconnect("task.reward", "learner.reward");
  EXPECT_EQ(live_.active_task().name(), "second");
}

TEST_F(LiveGraphTest, AModuleStartsAsSoonAsItsInPortsAreConnected) {
  live_.AddModule("Reader", "reader", {{"count", int64_t{4}}});
  EXPECT_EQ(live_.Get("reader.count"), ParameterValue(int64_t{4}));
  const std::string why =
      "`reader.in` is not connected: connect it to an out port of the type "
      "`vector`";
  EXPECT_EQ(live_.WhyNotStarted("reader"), why);
  EXPECT_EQ(live_.WhyNotStarted("mind"), "");
  EXPECT_EQ(
      Refusal([&] { live_.Connect("learner.features", "reader.out"); }),
      "cannot connect `reader.out` to `learner.features`: `reader` is not started yet: " + why);
  EXPECT_EQ(Refusal([&] { live_.Connect("reader.note", "task.reward"); }),
            "cannot connect `reader.note` to `task.reward`: `reader` is not started yet: " + why);
  live_.Connect("mind.features", "reader.in");
  EXPECT_EQ(live_.WhyNotStarted("reader"), "");
  live_.Connect("reader.note", "task.reward");
}

TEST_F(LiveGraphTest, AModuleThatCannotBeMadeIsNotAdded) {
  EXPECT_EQ(Refusal([&] { live_.AddModule("Raeder", "reader", {}); }),
            "there is no module type `Raeder`: did you mean `Reader`?");
  EXPECT_EQ(Refusal([&] { live_.AddModule("Reader", "mind", {}); }),
            "there is a module `mind` already");
  EXPECT_EQ(Refusal([&] {
              live_.AddModule("Reader", "reader", {{"count", 10.0}});
            }),
            "`reader.count` is an integer, and 10.0 is not one");
  EXPECT_EQ(Refusal([&] { live_.AddModule("UniversalTask", "more", {}); }),
            "`more` is a task module: load a task under this name");
}

TEST_F(LiveGraphTest, OnlyWhatNobodyNeedsIsRemoved) {
  for (const char* name : {"environment", "learner", "task"}) {
    EXPECT_EQ(Refusal([&] { live_.RemoveModule(name); }),
              std::string("the run cannot do without `") + name + "`");
  }
  EXPECT_EQ(
      Refusal([&] { live_.RemoveModule("mind"); }),
      "`mind.features` is read by `learner.features`: connect that to another out port first");
  EXPECT_EQ(Refusal([&] { live_.RemoveModule("mnd"); }),
            "there is no module `mnd`: did you mean `mind`?");
  const std::string before = Everything();
  live_.AddModule("Reader", "reader", {});
  live_.RemoveModule("reader");  // never started
  EXPECT_EQ(live_.WhyNotStarted("reader"), "");
  live_.AddModule("Reader", "reader", {});
  live_.Connect("mind.features", "reader.in");
  live_.RemoveModule("reader");
  EXPECT_EQ(Everything(), before);
}

}  // namespace
}  // namespace runtime
