#include "runtime/training/environment/stepped_environment.h"

#include <gmock/gmock.h>

#include <limits>
#include <string>
#include <vector>

#include "runtime/core/module/episode_seed.h"

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr uint64_t kRunSeed = 7;

const robot::RobotDescription kNoRobot;

// A point that goes as far as it is told.
class Line : public SteppedEnvironment {
 public:
  explicit Line(double time_step = 0.1, double low = -1, double high = 2)
      : SteppedEnvironment(
            "line", Context{&kNoRobot, {}, kRunSeed}, time_step,
            {Eigen::VectorXd::Constant(1, low), Eigen::VectorXd::Constant(1, high)}) {
    AddSensor("place", "real", "m", &place);
  }

  double place = 0;
  double end_at = 100;
  EndKind kind = EndKind::kFailure;
  std::vector<uint64_t> seeds;

 private:
  void Begin(uint64_t seed) override {
    seeds.push_back(seed);
    place = 0;
  }
  void Step(const Eigen::VectorXd& action) override {
    place += action[0];
    if (place >= end_at) EndEpisode(kind, "too far");
  }
};

// Hears of everything, and acts.
class Actor : public Module {
 public:
  explicit Actor(Environment& line) : Module("actor") {
    Port::Connect(action_, line.FindPort("action"));
    for (Port* slot : ports()) {
      if (slot->kind() == PortKind::kSlot) Port::Connect(line.FindPort(slot->name()), *slot);
    }
    Port::Connect(line.FindPort("time"), time_);
  }

  Eigen::VectorXd action = Eigen::VectorXd::Zero(1);
  std::vector<std::string> events;
  std::vector<double> times;

 private:
  void Note(const char* event) {
    events.emplace_back(event);
    times.push_back(*time_().reals());
  }
  void Start() override {}
  void OnStart() { Note("start of episode"); }
  void OnStartOfStep(double) { Note("start of time step"); }
  void OnStartOfPhysics(double) { Note("start of physics step"); }
  void OnEndOfPhysics(double) { Note("end of physics step"); }
  void OnEndOfStep(double) { Note("end of time step"); }
  void OnEnd(EpisodeEnd end) { Note(end.reason); }

  SensorIn time_{this, "time", "real [s]"};
  Out<Eigen::VectorXd> action_{this, "action", &action};
  Slot<> start_{this, "start_of_episode", Bind<&Actor::OnStart>{}};
  Slot<double> start_of_step_{this, "start_of_time_step", Bind<&Actor::OnStartOfStep>{}};
  Slot<double> start_of_physics_{this, "start_of_physics_step", Bind<&Actor::OnStartOfPhysics>{}};
  Slot<double> end_of_physics_{this, "end_of_physics_step", Bind<&Actor::OnEndOfPhysics>{}};
  Slot<double> end_of_step_{this, "end_of_time_step", Bind<&Actor::OnEndOfStep>{}};
  Slot<EpisodeEnd> end_{this, "end_of_episode", Bind<&Actor::OnEnd>{}};
};

void StartEpisode(Environment& environment) {
  environment.StartDrawnEpisode([](uint32_t) { return std::nullopt; });
}

TEST(SteppedEnvironment, EventsHaveTheOrderOfTheHeader) {
  Line line;
  Actor actor(line);
  StartEpisode(line);
  line.RunTimeStep();
  EXPECT_THAT(actor.events,
              ElementsAre("start of episode", "start of time step", "start of physics step",
                          "end of physics step", "end of time step"));
  EXPECT_THAT(actor.times, ElementsAre(0, 0, 0, 0.1, 0.1));
}

TEST(SteppedEnvironment, TimeIsCountedWithoutDrift) {
  Line line(0.01);
  StartEpisode(line);
  for (int i = 0; i < 2000; ++i) line.RunTimeStep();
  EXPECT_EQ(line.time(), 20.0);
  StartEpisode(line);
  EXPECT_EQ(line.time(), 0);
}

TEST(SteppedEnvironment, ActionsAreCutOffAtTheLimits) {
  Line line;
  Actor actor(line);
  StartEpisode(line);
  const auto after = [&](double action) {
    actor.action[0] = action;
    line.RunTimeStep();
    return line.place;
  };
  EXPECT_EQ(after(5), 2);
  EXPECT_EQ(after(-5), 1);
  EXPECT_EQ(after(0.5), 1.5);
  EXPECT_EQ(after(kNan), 1.5);
  actor.action.resize(2);
  EXPECT_THROW(line.RunTimeStep(), UserError);
}

TEST(SteppedEnvironment, WhatNobodyActsOnIsToldTheLimitNearestTo0) {
  Line line(0.1, 1, 2);
  StartEpisode(line);
  line.RunTimeStep();
  EXPECT_EQ(line.place, 1);
}

TEST(SteppedEnvironment, TheSeedOfAnEpisodeFollowsFromItsNumber) {
  Line line;
  StartEpisode(line);
  StartEpisode(line);
  line.SetNextEpisode(12);
  StartEpisode(line);
  EXPECT_THAT(line.seeds, ElementsAre(EpisodeSeed(kRunSeed, 1), EpisodeSeed(kRunSeed, 2),
                                      EpisodeSeed(kRunSeed, 12)));
}

// A learner may end the episode with its action only.
TEST(SteppedEnvironment, AfterItsEndTheStateStaysAndTheEventsGoOn) {
  Line line;
  Actor actor(line);
  line.end_at = 2;
  StartEpisode(line);
  actor.action[0] = 2;
  line.RunTimeStep();
  EXPECT_EQ(actor.events.back(), "too far");
  line.RunTimeStep();
  EXPECT_EQ(line.place, 2);
  EXPECT_EQ(actor.events.back(), "end of time step");
  EXPECT_EQ(line.time(), 0.2);
}

TEST(SteppedEnvironment, AfterAnEpisodeThatDivergedNothingHappens) {
  Line line;
  Actor actor(line);
  line.end_at = 2;
  line.kind = EndKind::kDiverged;
  StartEpisode(line);
  actor.action[0] = 2;
  line.RunTimeStep();
  line.RunTimeStep();
  EXPECT_EQ(actor.events.back(), "too far");
  StartEpisode(line);
  EXPECT_EQ(actor.events.back(), "start of episode");
}

TEST(SteppedEnvironment, NothingHappensBeforeTheFirstEpisode) {
  Line line;
  const Actor actor(line);
  line.RunTimeStep();
  EXPECT_TRUE(actor.events.empty());
}

TEST(SteppedEnvironment, NothingOfItIsRecorded) {
  const Line line;
  EXPECT_EQ(line.pose_count(), 0);
  EXPECT_EQ(line.profile(), "");
  EXPECT_EQ(line.WhyOnlyOne(), "");
}

TEST(SteppedEnvironment, WrongStepsAndLimitsAreRefused) {
  const auto refusal = [](auto... arguments) -> std::string {
    try {
      const Line line(arguments...);
    } catch (const UserError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(refusal(0.0), HasSubstr("the time step of `line` is 0 s: it must be above 0"));
  EXPECT_THAT(refusal(kNan), HasSubstr("it must be above 0"));
  EXPECT_THAT(refusal(0.1, 1.0, 0.0), HasSubstr("the action limits of `line` are none"));
  EXPECT_THAT(refusal(0.1, kNan, 0.0), HasSubstr("the action limits of `line` are none"));
}

}  // namespace
}  // namespace runtime
