// Params, goals, and what an episode starts from.
#include <fmt/format.h>
#include <taskc/host.h>

#include <cmath>
#include <span>

#include "libtaskc/failure.h"
#include "libtaskc/instance.h"
#include "libtaskc/lookup.h"
#include "plugins/host/scalar_bytes.h"

namespace libtaskc {
namespace {

size_t ParamOf(const taskc_instance& instance, const char* name) {
  const taskc_plugin& task = instance.task();
  return IndexOf(task, std::span(task.params, task.param_count), name, "param");
}

void CheckParam(const taskc_param& param, double value) {
  if (!(param.minimum <= value && value <= param.maximum)) {
    throw Failure(
        TASKC_ERROR_OUT_OF_RANGE,
        fmt::format("the param `{}` must be within {} .. {}{}{}, not {}", param.name, param.minimum,
                    param.maximum, *param.unit == '\0' ? "" : " ", param.unit, value));
  }
  if (param.scalar == TASKC_REAL ? std::isfinite(value) : value == std::trunc(value)) return;
  throw Failure(TASKC_ERROR_OUT_OF_RANGE,
                fmt::format("the param `{}` is {}, and {} is none", param.name,
                            param.scalar == TASKC_INT ? "an int" : "a real number", value));
}

const taskc_goal& GoalOf(const taskc_instance& instance, const char* name) {
  const taskc_plugin& task = instance.task();
  return task.goals[IndexOf(task, std::span(task.goals, task.goal_count), name, "goal")];
}

void CheckGoalElement(const taskc_goal& goal, double element) {
  const bool fits = goal.scalar == TASKC_REAL ? std::isfinite(element)
                    : goal.scalar == TASKC_INT
                        ? element == std::trunc(element) && std::abs(element) <= 0x1p53
                        : element == 0 || element == 1;
  if (fits) return;
  throw Failure(TASKC_ERROR_OUT_OF_RANGE,
                fmt::format("the goal `{}` is a `{}`, of which {} cannot be an element", goal.name,
                            goal.type, element));
}

}  // namespace
}  // namespace libtaskc

using namespace libtaskc;

taskc_status taskc_set_param(taskc_instance* instance, const char* param, const char* unit,
                             double value) {
  return Guarded([&] {
    RequirePointer(instance, "the instance");
    const size_t index = ParamOf(*instance, param);
    const taskc_param& entry = instance->task().params[index];
    CheckUnit(unit, entry.unit, entry.name);
    CheckParam(entry, value);
    instance->frame().params()[index] = value;
  });
}

taskc_status taskc_get_param(const taskc_instance* instance, const char* param, double* value) {
  return Guarded([&] {
    RequirePointer(instance, "the instance");
    RequirePointer(value, "the place for the value");
    *value = instance->frame().params()[ParamOf(*instance, param)];
  });
}

taskc_status taskc_set_discount(taskc_instance* instance, double discount) {
  return Guarded([&] {
    RequirePointer(instance, "the instance");
    if (!(discount >= 0 && discount <= 1)) {
      throw Failure(TASKC_ERROR_OUT_OF_RANGE,
                    fmt::format("the discount must be within 0 .. 1, not {}", discount));
    }
    instance->frame().SetDiscount(discount);
  });
}

taskc_status taskc_get_goal(taskc_instance* instance, const char* goal, double* elements) {
  return Guarded([&] {
    RequirePointer(instance, "the instance");
    RequirePointer(elements, "the place for the elements");
    const taskc_goal& entry = GoalOf(*instance, goal);
    instance->episode.Initialize();
    const std::byte* place = instance->frame().Bytes(entry).data();
    for (taskc_uint32 i = 0; i < entry.rows * entry.columns; ++i)
      elements[i] = host::LoadScalar(place + i * host::ScalarSize(entry.scalar), entry.scalar);
  });
}

taskc_status taskc_hold_goal(taskc_instance* instance, const char* goal, const char* unit,
                             const double* elements) {
  return Guarded([&] {
    RequirePointer(instance, "the instance");
    RequirePointer(elements, "the value of the goal");
    const taskc_goal& entry = GoalOf(*instance, goal);
    CheckUnit(unit, entry.unit, entry.name);
    const std::span values(elements, entry.rows * entry.columns);
    for (const double element : values) CheckGoalElement(entry, element);
    instance->episode.Initialize();
    std::byte* place = instance->frame().Bytes(entry).data();
    for (const double element : values) {
      host::StoreScalar(place, entry.scalar, element);
      place += host::ScalarSize(entry.scalar);
    }
    instance->frame().Hold(entry, true);
  });
}

taskc_status taskc_release_goal(taskc_instance* instance, const char* goal) {
  return Guarded([&] {
    RequirePointer(instance, "the instance");
    const taskc_goal& entry = GoalOf(*instance, goal);
    instance->episode.Initialize();
    instance->frame().Hold(entry, false);
  });
}

taskc_status taskc_draw_pose(taskc_instance* instance, taskc_uint64 seed, const char** pose) {
  return Guarded([&] {
    RequirePointer(instance, "the instance");
    RequirePointer(pose, "the place for the pose");
    const taskc_plugin& task = instance->task();
    instance->frame().SetSeed(seed);
    instance->episode.Initialize();
    const taskc_int32 drawn = instance->frame().DrawPose();
    const bool is_named = drawn >= 0 && static_cast<taskc_uint32>(drawn) < task.pose_count;
    *pose = is_named ? task.poses[drawn].name : nullptr;
  });
}

taskc_status taskc_get_start_value(taskc_instance* instance, const char* name, double** elements) {
  return Guarded([&] {
    RequirePointer(instance, "the instance");
    RequirePointer(elements, "the place for the elements");
    const taskc_plugin& task = instance->task();
    const std::span values(task.start_values, task.start_value_count);
    const size_t index = IndexOf(task, values, name, "start value");
    *elements = instance->frame().Elements(values[index]).data();
  });
}

taskc_status taskc_draw_start(taskc_instance* instance, taskc_uint32 attempt) {
  return Guarded([&] {
    RequirePointer(instance, "the instance");
    instance->episode.Initialize();
    instance->frame().DrawStart(attempt);
  });
}
