// What loops, functions, logs, requirements and the setting of elements do in a real plugin.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/compiler/emit/compiled_task.h"

namespace compiler {
namespace {

using testing::ElementsAre;
using testing::StrEq;

std::vector<double> ElementsOf(const Instance& instance, const std::string& memory, size_t count) {
  std::vector<double> values;
  for (size_t i = 0; i < count; ++i) values.push_back(instance.Memory(memory, i));
  return values;
}

TEST(Constructs, LoopsRunOncePerValue) {
  CompiledTask task(R"(task t
memory added: real = 0
memory last: int = -1
memory marks: int[5] = 0
on end_of_action {
  for i in {1 .. 4} - {2} {
    let square = i * i
    added += square
    for k in 0 .. 1 { marks[i] = 10 * i + k }
    last = i
  }
  let square = 100
  reward all = added + square
}
)");
  Instance instance(task);
  instance.Fire(TASKC_END_OF_ACTION);
  EXPECT_EQ(instance.reward(), 1 + 9 + 16 + 100);
  EXPECT_EQ(instance.Memory("last"), 4);
  EXPECT_THAT(ElementsOf(instance, "marks", 5), ElementsAre(0, 11, 0, 31, 41));
}

TEST(Constructs, ElementsAreSetByScalarsAndByElements) {
  CompiledTask task(R"(task t
sensor v: vec3
sensor touch: bool[3]
memory place: vec3 = 1
memory flags: bool[4] = false
memory trail: real[40] = 0
on end_of_action {
  place.xz += v.xy
  place.y = 7
  flags[1, 3] = touch[0, 2]
  trail[2 .. 38] = 3
  trail[0, 2 .. 36] += 1
}
on start_of_action {
  place.yx = place.xz
  place.xy += place.x
}
)");
  Instance instance(task);
  instance.Sense("v", {5, 6, -1});
  instance.Sense("touch", {1, 1, 0});
  instance.Fire(TASKC_END_OF_ACTION);
  EXPECT_THAT(ElementsOf(instance, "place", 3), ElementsAre(6, 7, 7));
  EXPECT_THAT(ElementsOf(instance, "flags", 4), ElementsAre(0, 1, 0, 0));
  EXPECT_THAT(ElementsOf(instance, "trail", 4), ElementsAre(1, 0, 4, 4));
  EXPECT_EQ(instance.Memory("trail", 36), 4);
  EXPECT_EQ(instance.Memory("trail", 37), 3);
  EXPECT_EQ(instance.Memory("trail", 39), 0);
  instance.Fire(TASKC_START_OF_ACTION);
  // First (x, y) = (z, x) = (7, 6); then both rise by the x from before.
  EXPECT_THAT(ElementsOf(instance, "place", 3), ElementsAre(14, 13, 7));
}

TEST(Constructs, FunctionsTakeAndGiveValuesOfAllShapes) {
  CompiledTask task(R"(task t
sensor v: vec3
sensor b: bool[3]
fn summed(x: vec3, more: int) -> real = sum(x) + more
fn turned(x: vec3, by: real) -> vec3 { let y = x.yzx * by  return y - x }
fn reversed(p: bool[3]) -> bool[3] = p[2, 1, 0]
fn twice(x: vec3) -> vec3 = turned(turned(x, 2), summed(x, 1))
metric sum_of_turned = summed(turned(v, 3), 2)
memory place: vec3 = 0
memory flags: bool[3] = false
on end_of_action {
  place = twice(v)
  flags = reversed(b)
  if reversed(b)[0] or summed(v, 0) < 7 { reward all = 1 }
}
)");
  Instance instance(task);
  instance.Sense("v", {1, 2, 4});
  instance.Sense("b", {1, 0, 0});
  instance.Fire(TASKC_END_OF_ACTION);
  // turned((1, 2, 4), 2) = (3, 6, -2); total + 1 = 8; turned((3, 6, -2), 8) = (45, -22, 26).
  EXPECT_THAT(ElementsOf(instance, "place", 3), ElementsAre(45, -22, 26));
  EXPECT_THAT(ElementsOf(instance, "flags", 3), ElementsAre(0, 0, 1));
  EXPECT_EQ(instance.reward(), 0);
  instance.Measure();
  EXPECT_EQ(instance.Metric("sum_of_turned"), 16);
}

TEST(Constructs, ConstsAreTheirValues) {
  CompiledTask task(R"(task t
const half: real = length / 10
const length: real = norm(corner) + 0 * most
const corner: vec3 = vec3(3, 2 * most, 0)
const most: int = 2
const wide: real[40] = -half
set ends = {0, most, inner + 30}
set inner = 1..most
memory seen: vec3 = 0
memory every: real[40] = 1
fn shift(v: vec3, most: vec3) -> vec3 = v + corner * half - most
on end_of_action {
  seen = shift(corner, corner[{0, 1, 2}])
  every = every - wide
  for i in ends - inner { reward paid = i + wide[i] }
  reward paid = count(select(half == 0.5, inner_of(true), inner_of(false))) * 1000
}
fn inner_of(b: bool) -> bool[2] = both
const both: bool[2] = true
)");
  Instance instance(task);
  instance.Initialize();
  instance.Fire(TASKC_END_OF_ACTION);
  EXPECT_THAT(ElementsOf(instance, "seen", 3), ElementsAre(1.5, 2, 0));
  EXPECT_EQ(instance.Memory("every", 39), 1.5);
}

TEST(Constructs, LogsAddUp) {
  CompiledTask task(R"(task t
sensor x: real [m]
on end_of_action {
  if x < 10 m { log min depth = x }
  log mean effort = 2 * x / 1 m
}
)");
  const taskc_plugin& plugin = task.plugin();
  ASSERT_EQ(plugin.log_count, 2u);
  EXPECT_THAT(plugin.logs[0].unit, StrEq("m"));
  EXPECT_EQ(plugin.logs[0].reduction, TASKC_MIN);
  EXPECT_EQ(plugin.logs[0].place.line, 4u);
  EXPECT_EQ(plugin.logs[1].reduction, TASKC_MEAN);
  Instance instance(task);
  for (double x : {3.0, 11.0, -2.0, 5.0}) {
    instance.Sense("x", {x});
    instance.Fire(TASKC_END_OF_ACTION);
  }
  const taskc_log_state& depth = instance.Log("depth");
  EXPECT_EQ(depth.count, 3);
  EXPECT_EQ(depth.last, 5);
  EXPECT_EQ(depth.sum, 6);
  EXPECT_EQ(depth.minimum, -2);
  EXPECT_EQ(depth.maximum, 5);
  EXPECT_EQ(instance.Log("effort").sum, 34);
  instance.Sense("x", {std::nan("")});
  instance.Fire(TASKC_END_OF_ACTION);
  instance.Sense("x", {1});
  instance.Fire(TASKC_END_OF_ACTION);
  EXPECT_TRUE(std::isnan(instance.Log("effort").minimum));
  EXPECT_EQ(depth.count, 4);  // a comparison with what is no number does not hold
}

TEST(Constructs, TheFirstRequirementThatDoesNotHoldIsReported) {
  CompiledTask task(R"(task t
sensor x: real
memory after: int = 0
after_end continue
on end_of_action {
  require x < 3 "small"
  require x < 2
  after += 1
  reward pay = 1
  if x > 0 { end_episode success "there" }
}
)");
  const taskc_plugin& plugin = task.plugin();
  ASSERT_EQ(plugin.requirement_count, 2u);
  EXPECT_THAT(plugin.requirements[0].reason, StrEq("small"));
  EXPECT_THAT(plugin.requirements[1].reason, StrEq("x < 2"));
  EXPECT_EQ(plugin.requirements[1].place.line, 7u);
  Instance instance(task);
  for (auto [x, violation] : {std::pair(1.0, -1), {2.5, 1}, {4.0, 0}, {std::nan(""), 0}}) {
    instance.Sense("x", {x});
    instance.Fire(TASKC_END_OF_ACTION);
    EXPECT_EQ(instance.violation(), violation) << x;
    EXPECT_EQ(instance.reward(), 1);
  }
  EXPECT_EQ(instance.Memory("after"), 4);
}

TEST(Constructs, OnceHappensOncePerItsTime) {
  CompiledTask task(R"(task t
memory once_1: int = 5
on end_of_time_step {
  once per action if once_1 == 5 { reward act = 1 }
  once per episode if true { reward episode = 10 }
  once per run if true { reward run = 100 }
}
)");
  Instance instance(task);
  std::vector<double> rewards;
  for (int event : {TASKC_START_OF_EPISODE, TASKC_START_OF_ACTION, TASKC_END_OF_TIME_STEP,
                    TASKC_END_OF_TIME_STEP, TASKC_START_OF_ACTION, TASKC_END_OF_TIME_STEP,
                    TASKC_START_OF_EPISODE, TASKC_START_OF_ACTION, TASKC_END_OF_TIME_STEP}) {
    instance.Fire(event, 0.005);
    if (event == TASKC_END_OF_TIME_STEP) rewards.push_back(instance.reward());
  }
  EXPECT_THAT(rewards, ElementsAre(111, 0, 1, 11));
}

TEST(Constructs, OnceDoesOneOfItsBranches) {
  CompiledTask task(R"(task t
memory n: int = 0 per run
on end_of_time_step {
  n += 1
  once per episode if n == 2 or n == 5 { reward a = 1 } else if n == 1 or n == 6 { reward b = 10 }
  once per episode if n == 2 { reward c = 100 } else if n >= 2 { reward d = 1000 }
}
)");
  Instance instance(task);
  std::vector<double> rewards;
  for (int step = 0; step < 6; ++step) {
    if (step == 3) instance.Fire(TASKC_START_OF_EPISODE, 0);
    instance.Fire(TASKC_END_OF_TIME_STEP, 0.005);
    rewards.push_back(instance.reward());
  }
  // n is 1, 2, 3, and in the second episode 4, 5, 6.
  EXPECT_THAT(rewards, ElementsAre(10, 100, 0, 1000, 1, 0));
}

TEST(Constructs, AGoalMayFollowFromAnother) {
  CompiledTask task(R"(task t
goal angle: real [rad] = uniform(0 rad, 1 rad)
goal place: vec2 = vec2(cos(angle), sin(angle))
on end_of_time_step { reward x = place.x }
)");
  Instance instance(task);
  for (taskc_uint64 seed : {1, 2}) {
    instance.SetSeed(seed);
    instance.Fire(TASKC_START_OF_EPISODE);
    EXPECT_EQ(instance.Goal("place", 0), std::cos(instance.Goal("angle")));
    EXPECT_EQ(instance.Goal("place", 1), std::sin(instance.Goal("angle")));
  }
}

}  // namespace
}  // namespace compiler
