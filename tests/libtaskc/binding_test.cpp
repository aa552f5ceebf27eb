#include <gmock/gmock.h>
#include <taskc/host.h>

#include <string>
#include <vector>

#include "tests/libtaskc/opened_task.h"

namespace libtaskc {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::vector<double> Observed(taskc_instance* instance) {
  const double* numbers = nullptr;
  EXPECT_EQ(taskc_observe(instance, &numbers), TASKC_OK) << taskc_error();
  return {numbers, numbers + 7};
}

class BindTest : public testing::Test {
 protected:
  BindTest() { Bind(instance_, world_); }
  void Start() { ASSERT_EQ(taskc_start_episode(instance_, 1, nullptr), TASKC_OK) << taskc_error(); }
  double RewardOfAStep() {
    taskc_result result;
    EXPECT_EQ(taskc_event(instance_, TASKC_END_OF_TIME_STEP, 0.5, &result), TASKC_OK);
    return result.reward;
  }

  OpenedTask task_{"each"};
  Instance instance_{task_};
  World world_;
};

TEST_F(BindTest, WhatTheHostHasIsReadAtEachEvent) {
  Start();
  EXPECT_EQ(RewardOfAStep(), 1);
  world_.place[0] = 3;
  EXPECT_EQ(RewardOfAStep(), 3);
  world_.touches[2] = 7;
  EXPECT_EQ(RewardOfAStep(), 4);
}

TEST_F(BindTest, QuaternionsAreTurnedAroundByName) {
  Start();
  EXPECT_THAT(Observed(instance_), ElementsAre(0, -2, -2.5, 0, 0.25, 0.5, 0.75));
}

// A column of a table with four of them, from below.
TEST_F(BindTest, StridesMayLeadAnywhere) {
  const float table[3][4] = {{0, 0, 30, 0}, {0, 0, 20, 0}, {0, 0, 10, 0}};
  const taskc_view view{.data = &table[2][2],
                        .format = TASKC_FLOAT32,
                        .row_stride = -static_cast<ptrdiff_t>(sizeof table[0]),
                        .rows = 3,
                        .columns = 1};
  ASSERT_EQ(taskc_bind(instance_, "place", "m", view), TASKC_OK) << taskc_error();
  Start();
  EXPECT_THAT(Observed(instance_), ElementsAre(9, 18, 27, 0, 0.25, 0.5, 0.75));
}

TEST_F(BindTest, AFunctionIsCalledBeforeEachEventThatReadsTheSensor) {
  struct Counter {
    int calls = 0;
  } counter;
  const auto read = [](void* user, void* elements) {
    auto* place = static_cast<double*>(elements);
    place[0] = ++static_cast<Counter*>(user)->calls;
    place[1] = place[2] = 0;
  };
  ASSERT_EQ(taskc_bind_function(instance_, "place", "m", read, &counter), TASKC_OK);
  Start();
  const int before = counter.calls;
  taskc_event(instance_, TASKC_END_OF_ACTION, 0, nullptr);
  EXPECT_EQ(counter.calls, before);
  EXPECT_EQ(RewardOfAStep(), before + 1);
}

TEST(BindEntryTest, TheOnlyEntryOfASensorIsTheWholeSensor) {
  const OpenedTask task("single");
  const Instance instance(task);
  double door = 2;
  ASSERT_EQ(taskc_bind(instance, "doors[0]", "", {.data = &door, .format = TASKC_FLOAT64}),
            TASKC_OK)
      << taskc_error();
  ASSERT_EQ(taskc_start_episode(instance, 1, nullptr), TASKC_OK) << taskc_error();
  door = 3;
  taskc_result result;
  ASSERT_EQ(taskc_event(instance, TASKC_END_OF_TIME_STEP, 0.5, &result), TASKC_OK);
  EXPECT_EQ(result.reward, 3);
}

TEST_F(BindTest, EntriesAreBoundByNumber) {
  const Instance instance(task_);
  Bind(instance, world_);
  const unsigned char touch = 1;
  for (const char* entry : {"touches[0]", "touches[2]"})
    ASSERT_EQ(taskc_bind(instance, entry, "", {.data = &touch, .format = TASKC_UINT8}), TASKC_OK);
  EXPECT_EQ(taskc_start_episode(instance, 1, nullptr), TASKC_ERROR_NOT_BOUND);
  EXPECT_THAT(taskc_error(), HasSubstr("reads `touches[1]`, which is not bound"));
  EXPECT_EQ(taskc_bind(instance, "touches[3]", "", {.data = &touch, .format = TASKC_UINT8}),
            TASKC_ERROR_UNKNOWN_NAME);
  EXPECT_STREQ(taskc_error(), "the sensor `touches` has the entries 0 .. 2, not 3");
}

// The robot's joints in the host's own order.
TEST(BindJoints, EntriesAreBoundByTheNamesOfLinksAndJoints) {
  const OpenedTask task("crawling");
  const Instance instance(task);
  std::vector<double> torques(task.table().joint_count, 0.0);
  for (taskc_uint32 i = 0; i < task.table().joint_count; ++i) {
    const std::string entry = std::string("joint.torque[") + task.table().joints[i].name + "]";
    ASSERT_EQ(taskc_bind(instance, entry.c_str(), "N m",
                         {.data = &torques[task.table().joint_count - 1 - i]}),
              TASKC_OK)
        << taskc_error();
  }
  EXPECT_EQ(taskc_bind(instance, "joint.torque[left_kne_pitch]", nullptr, {.data = torques.data()}),
            TASKC_ERROR_UNKNOWN_NAME);
  EXPECT_THAT(taskc_error(), HasSubstr("did you mean `left_knee_pitch`?"));
  EXPECT_EQ(taskc_start_episode(instance, 1, nullptr), TASKC_ERROR_NOT_BOUND);
  EXPECT_THAT(taskc_error(), Not(HasSubstr("joint.torque")));
}

TEST(BindSites, EntriesAreBoundByTheNamesOfSites) {
  const OpenedTask task("tips");
  const Instance instance(task);
  const double place[3] = {};
  for (taskc_uint32 i = 0; i < task.table().site_count; ++i) {
    const std::string entry = std::string("site.position[") + task.table().sites[i].name + "]";
    ASSERT_EQ(taskc_bind(instance, entry.c_str(), "m", {.data = place}), TASKC_OK) << taskc_error();
  }
  EXPECT_EQ(taskc_bind(instance, "site.velocity[left_to]", nullptr, {.data = place}),
            TASKC_ERROR_UNKNOWN_NAME);
  EXPECT_THAT(taskc_error(), HasSubstr("did you mean `left_toe`?"));
}

struct Mistake {
  const char* sensor;
  const char* unit;
  taskc_view view;
  taskc_status status;
  const char* message;
};

TEST_F(BindTest, MistakesAreNamed) {
  const double data[12] = {};
  const Mistake mistakes[] = {
      {"plase",
       "m",
       {.data = data},
       TASKC_ERROR_UNKNOWN_NAME,
       "the task `each` has no sensor `plase`: did you mean `place`?"},
      {"place", "cm", {.data = data}, TASKC_ERROR_WRONG_UNIT, "`place` is in `m`, not in `cm`"},
      {"turn",
       "rad",
       {.data = data},
       TASKC_ERROR_WRONG_UNIT,
       "`turn` is a plain number, not in `rad`"},
      {"place", "m", {.data = nullptr}, TASKC_ERROR_NULL, "the data of the view is null"},
      {"place",
       "m",
       {.data = data, .rows = 2, .columns = 1},
       TASKC_ERROR_WRONG_TYPE,
       "the sensor `place`, a `vec3`, has 3 x 1 elements, and the host's has 2 x 1"},
      {"place", "m", {.data = data, .format = 9}, TASKC_ERROR_WRONG_TYPE, "there is no format 9"},
      {"steps",
       "",
       {.data = data},
       TASKC_ERROR_WRONG_TYPE,
       "the sensor `steps` is of ints, and takes no floats"},
      {"place",
       "m",
       {.data = data, .quaternions = TASKC_XYZW},
       TASKC_ERROR_WRONG_TYPE,
       "the sensor `place` is a `vec3`, whose elements have no order 1"},
      {"place[0]",
       "m",
       {.data = data},
       TASKC_ERROR_UNKNOWN_NAME,
       "the sensor `place` has no entries: it is a `vec3`"}};
  for (const Mistake& mistake : mistakes) {
    EXPECT_EQ(taskc_bind(instance_, mistake.sensor, mistake.unit, mistake.view), mistake.status);
    EXPECT_STREQ(taskc_error(), mistake.message);
  }
  Start();  // none of them has changed anything
  EXPECT_EQ(RewardOfAStep(), 1);
}

}  // namespace
}  // namespace libtaskc
