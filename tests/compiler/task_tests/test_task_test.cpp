// The `test` blocks of tasks.
#include "compiler/task_tests/test_task.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/compiler/check/checked_source.h"
#include "tests/compiler/temporary_folder.h"

namespace compiler {
namespace {

using testing::ElementsAre;

constexpr const char* kTask = R"(task tested for humanoid
param penalty: real = 4
memory fallen: bool = false per action
memory place: vec3 [m] = 1 m
metric height = base.position.z
metric attitude = sum(base.orientation.wxyz) + sum(base.rotation[1, 0..2])
metric axes = norm(base.forward + base.left)
on end_of_time_step {
  reward rate up = base.up.z
  if not fallen and any(contact[body, head]) {
    fallen = true
    reward fall = -penalty
    log impact = norm(base.velocity)
  }
  require base.position.z > -1 m "above the ground"
  if base.position.x > 5 m { end_episode success "crosses the line" }
  if time > 20 s { truncate_episode "time is up" }
}
)";

// Each test as "ok", or what is said of it.
std::string ResultsOf(const std::string& task, const std::string& filter = "") {
  static const TemporaryFolder cache;
  const CheckedSource checked("tested.task", task);
  if (!checked.task) return checked.Messages();
  return ToText(TestTask(*checked.task, checked.sources, filter, cache.path()), checked.sources);
}

std::string TextOf(const std::string& tests, const std::string& filter = "") {
  return ResultsOf(kTask + tests, filter);
}

TEST(TestTask, RunsATestOfThePaper) {
  EXPECT_EQ(TextOf(R"(test "a fall is paid once in an action" {
  given contact[head] = true
  fire start_of_action, 2 * end_of_time_step
  expect total(fall) == -4
  expect fallen
}
)"),
            "ok      a fall is paid once in an action\n");
}

TEST(TestTask, TellsWhatItSaw) {
  EXPECT_EQ(TextOf(R"(test "too much" {
  given contact = true
  given base.velocity.xy = 3 m/s
  fire 2 * end_of_time_step
  expect total(fall) == -8
  expect fallen and value(impact) < 4 m/s
  expect not fallen
  expect ended
}
)"),
            R"(FAILED  too much
        tested.task:23: expect total(fall) == -8
            total(fall) is -4
        tested.task:24: expect fallen and value(impact) < 4 m/s
            value(impact) is 4.242640687119285 m/s
        tested.task:25: expect not fallen
        tested.task:26: expect ended
)");
}

TEST(TestTask, BeginsUprightAndAtRest) {
  EXPECT_EQ(TextOf(R"(test "rest" {
  expect base.orientation.w == 1
  expect base.rotation[2, 2] == 1 and base.rotation[0, 1] == 0
  expect base.up.z == 1 and base.forward.x == 1 and base.left.y == 1
  expect norm(base.velocity) == 0 and none(contact)
  expect place.y == 1 m and not ended
  fire end_of_time_step
  expect reward == 0.005
}
)"),
            "ok      rest\n");
}

TEST(TestTask, GivesParamsMemoryAndTheTimeStep) {
  EXPECT_EQ(TextOf(R"(test "given" {
  given penalty = 7
  given place.xy = 2 m
  given fallen = true
  given time_step = 10 ms
  fire end_of_time_step
  expect total(fall) == 0
  expect total(up) == 0.01
  expect place.x == 2 m and place.z == 1 m
  given fallen = false
  given contact[body] = true
  fire end_of_time_step
  expect total(fall) == -7
  given base.position.z = 0.5 m
  expect value(height) == 0.5 m
}
)"),
            "ok      given\n");
}

TEST(TestTask, ReducesMetricsAndLogsAsAnEpisodeDoes) {
  EXPECT_EQ(ResultsOf(R"(task reduced
sensor x: real
metric now = x
metric sum all = x
metric max high = x
metric min low = x
metric mean middle = x
on start_of_time_step { log sum added = x log max peak = x log min dip = x log mean level = x }
on end_of_time_step { if x > 90 { truncate_episode "far" } }
test "of three time steps" {
  given x = 3
  fire start_of_time_step, end_of_time_step
  given x = -1
  fire start_of_time_step, end_of_time_step
  given x = 10
  fire start_of_time_step, end_of_time_step
  given x = 7
  expect value(now) == 7 and value(all) == 12 and value(middle) == 4
  expect value(high) == 10 and value(low) == -1
  expect value(added) == 12 and value(level) == 4
  expect value(peak) == 10 and value(dip) == -1
}
test "of other events" {
  given x = 5
  fire start_of_time_step, end_of_action, start_of_physics_step
  expect value(all) == 0 and value(now) == 5 and value(added) == 5
}
test "of nothing" {
  expect value(all) == 0 and value(added) == 0
  expect value(middle) == 0
  expect value(peak) == 0
}
)"),
            R"(ok      of three time steps
ok      of other events
FAILED  of nothing
        tested.task:30: expect value(middle) == 0
            value(middle) is not a number
        tested.task:31: expect value(peak) == 0
            value(peak) is not a number
)");
}

TEST(TestTask, ComparesWithATolerance) {
  EXPECT_EQ(ResultsOf(R"(task near
const wanted: real [m] = 1 m
sensor x: real [m]
memory y: real [m] = 0
on end_of_time_step { y += 0.1 * x if x > 90 m { truncate_episode "far" } }
test "near" {
  given x = wanted
  fire 10 * end_of_time_step
  expect y == 1 m within 1e-9 m and not (y == wanted)
  expect y != wanted within 0 m and y != 2 m within 99 cm
  expect 2 * y == 2 m within 1 mm
}
test "not near" {
  given x = 0.5 m
  fire end_of_time_step
  expect y == wanted within 10 cm
  expect y == 0.04 m within 0.1 mm and y < 1 m
  expect y != 0.05 m within 1 mm
}
)"),
            R"(ok      near
FAILED  not near
        tested.task:16: expect y == wanted within 10 cm
            y is 0.05 m
            wanted is 1 m
            the difference is 0.95 m
        tested.task:17: expect y == 0.04 m within 0.1 mm and y < 1 m
            y is 0.05 m
            the difference is 0.010000000000000002 m
        tested.task:18: expect y != 0.05 m within 1 mm
            y is 0.05 m
            the difference is 0 m
)");
}

TEST(TestTask, OrientationImpliesRotation) {
  EXPECT_EQ(TextOf(R"(test "on its side" {
  given base.orientation = quat(1, 1, 0, 0)
  expect base.rotation[1, 2] == -1 and base.rotation[2, 1] == 1 and base.rotation[0, 0] == 1
  expect base.up.y == -1 and base.left.z == 1 and base.forward.x == 1 and base.up.z == 0
  fire end_of_time_step
  expect total(up) == 0
}
test "by elements" {
  given base.orientation.w = 0
  expect base.up.z == 1
  given base.orientation.x = 2
  expect base.up.z == -1
}
test "unless it is given itself" {
  given base.up.z = 0.5
  given base.orientation = quat(0, 1, 0, 0)
  expect base.up.z == 0.5 and base.left.y == -1
  given base.left = vec3(1, 2, 3)
  expect base.left.z == 3 and base.rotation[1, 1] == -1
}
)"),
            "ok      on its side\nok      by elements\nok      unless it is given itself\n");
}

TEST(TestTask, KnowsTheFirstEnd) {
  EXPECT_EQ(TextOf(R"(test "ends" {
  fire end_of_time_step
  expect truncate_episode "time is up"
  given time = 21 s
  fire end_of_time_step
  given base.position.x = 6 m
  fire end_of_time_step
  expect truncate_episode "time is up"
  expect end_episode success "crosses the line"
}
)"),
            R"(FAILED  ends
        tested.task:21: expect truncate_episode "time is up"
            the episode has not ended
        tested.task:27: expect end_episode success "crosses the line"
            it ended differently: truncate_episode "time is up"
)");
}

TEST(TestTask, PaysOnceBesideAnEnd) {
  EXPECT_EQ(TextOf(R"(test "once" {
  given time = 21 s
  fire 3 * end_of_time_step, start_of_action, end_of_time_step
  expect total(up) == 0.005
  fire start_of_episode, end_of_time_step
  expect total(up) == 0.01
}
test "a requirement" {
  given base.position.z = -2 m
  fire 3 * end_of_time_step
  expect ended and total(up) == 0.005
  expect truncate_episode "time is up"
}
)"),
            R"(ok      once
FAILED  a requirement
        tested.task:30: expect truncate_episode "time is up"
            the episode has ended by a requirement: above the ground
)");
}

TEST(TestTask, BeginsEachTestAnew) {
  const std::string test = R"({
  expect not fallen and total(fall) == 0
  given contact[body] = true
  fire end_of_time_step
  expect fallen
}
)";
  const std::string tests = "test \"one\" " + test + "test \"another\" " + test;
  EXPECT_EQ(TextOf(tests), "ok      one\nok      another\n");
  EXPECT_EQ(TextOf(tests, "other"), "ok      another\n");
  EXPECT_EQ(TextOf(tests, "none of them"), "");
}

}  // namespace
}  // namespace compiler
