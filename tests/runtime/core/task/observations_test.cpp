// What a task lets a learner see.
#include <gmock/gmock.h>

#include "runtime/core/task/universal_task.h"
#include "tests/runtime/core/task/allocation_count.h"
#include "tests/runtime/core/task/fake_modules.h"
#include "tests/runtime/core/task/test_plugins.h"

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;
using testing::UnorderedElementsAre;

class ObservationsTest : public testing::Test {
 protected:
  ObservationsTest() {
    for (Port* in : task_.ports()) {
      if (in->kind() == PortKind::kIn) Port::Connect(environment_.FindPort(in->name()), *in);
    }
    task_.Start();
    environment_.values("base.velocity") = {2, 4, 5};
    task_.on_start_of_episode();
  }

  robot::RobotDescription robot_ = Walker();
  FakeEnvironment environment_{robot_};
  UniversalTask task_{"task", robot_, std::make_unique<TaskInstance>(LoadTask("seeing"))};
};

TEST_F(ObservationsTest, AreComputedOnlyWhenTheyAreAskedFor) {
  task_.on_end_of_time_step(0.5);
  EXPECT_THAT(environment_.TakeReads(), IsEmpty());
  environment_.values("time") = {0.5};
  EXPECT_THAT(task_.Observe(), ElementsAre(0.5, 0.5, 0.25, 0.2));
  EXPECT_THAT(environment_.TakeReads(),
              UnorderedElementsAre(Pair("time", 1), Pair("base.velocity", 1)));
}

TEST_F(ObservationsTest, SayWhatTheyAre) {
  const ObservationLayout layout = task_.observation_layout();
  ASSERT_EQ(layout.values.size(), 2u);
  EXPECT_EQ(layout.size(), 4u);
  EXPECT_EQ(layout.values[1].name, "slowness");
  EXPECT_EQ(layout.values[1].type, "vec3");
  EXPECT_EQ(layout.values[1].unit, "s/m");
  EXPECT_EQ(layout.values[1].size, 3u);
  EXPECT_EQ(layout.values[0].maximum, 20);
}

TEST_F(ObservationsTest, WhatIsNotFiniteIsZeroAndCounted) {
  environment_.values("base.velocity") = {0, -0.0, 5};
  task_.on_end_of_time_step(0.5);
  EXPECT_THAT(task_.Observe(), ElementsAre(0, 0, 0, 0.2));
  ASSERT_EQ(task_.observation_faults().size(), 2u);
  EXPECT_EQ(task_.observation_faults()[0].count, 0);
  EXPECT_EQ(task_.observation_faults()[1].count, 2);
  EXPECT_EQ(task_.observation_faults()[1].first_time, 0.5);
  task_.on_start_of_episode();
  EXPECT_EQ(task_.observation_faults()[1].count, 0);
}

TEST_F(ObservationsTest, AllocateNothing) {
  const int64_t before = AllocationCount();
  task_.Observe();
  EXPECT_EQ(AllocationCount(), before);
}

TEST_F(ObservationsTest, ATaskWithoutThemShowsNothing) {
  const UniversalTask other("task", robot_, std::make_unique<TaskInstance>(LoadTask("told")));
  EXPECT_THAT(other.observation_layout().values, IsEmpty());
  EXPECT_THAT(other.Observe(), IsEmpty());
}

TEST_F(ObservationsTest, ADamagedTableIsRefused) {
  const std::string damaged = ".so: its table is damaged: ";
  const std::string remedy = "; build it again with `taskc build`";
  EXPECT_EQ(MessageOf([] { LoadTask("observation_outside"); }),
            "observation_outside" + damaged +
                "the observation `speed` lies outside of what is observed" + remedy);
  EXPECT_EQ(MessageOf([] { LoadTask("nothing_observes"); }),
            "nothing_observes" + damaged + "nothing computes what it observes" + remedy);
}

TEST(ObservationLayoutTest, OnlyTheSameCanBeGoneOnWith) {
  const ObservationLayout nothing;
  const ObservationLayout seen{{{.name = "a", .type = "real", .unit = "m"},
                                {.name = "b", .type = "vec3", .unit = "", .size = 3}}};
  const auto refusal = [](const ObservationLayout& expected, const ObservationLayout& layout) {
    return MessageOf([&] { CheckSameLayout(expected, layout, "the task `x`"); });
  };
  EXPECT_EQ(refusal(seen, seen), "no error");
  EXPECT_EQ(refusal(nothing, nothing), "no error");
  ObservationLayout other = seen;
  other.values[1].maximum = 2;
  EXPECT_EQ(refusal(seen, other), "no error");
  other.values[1].unit = "m";
  EXPECT_EQ(refusal(seen, other),
            "the learner cannot go on with the task `x`: it would see `b` (vec3 [m]) instead of "
            "`b` (vec3); train it in a run of its own");
  other.values.pop_back();
  EXPECT_EQ(refusal(seen, other),
            "the learner cannot go on with the task `x`: it would see nothing instead of `b` "
            "(vec3); train it in a run of its own");
  EXPECT_EQ(refusal(nothing, seen),
            "the learner cannot go on with the task `x`: it would see `a` (real [m]) instead of "
            "what the robot senses; train it in a run of its own");
}

}  // namespace
}  // namespace runtime
