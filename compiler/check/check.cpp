#include "compiler/check/check.h"

#include <cassert>

#include "compiler/check/after_end.h"
#include "compiler/check/declarations.h"
#include "compiler/check/functions.h"
#include "compiler/check/goals.h"
#include "compiler/check/sensor_use.h"
#include "compiler/check/statements.h"
#include "compiler/check/task_scope.h"
#include "compiler/check/test_blocks.h"
#include "compiler/check/warnings.h"

namespace compiler {

std::optional<CheckedTask> Check(const SyntaxTree& tree, const robot::RobotDescription* robot,
                                 Diagnostics& diagnostics, References* references) {
  assert(tree.robot.has_value() == (robot != nullptr));
  TaskScope scope{.has_robot = robot != nullptr,
                  .enumerations = EnumerationsOf(robot),
                  .sensors = {},
                  .symbols = {},
                  .functions = {},
                  .locals = {},
                  .diagnostics = diagnostics,
                  .loop_reads = nullptr,
                  .statements = 0,
                  .is_too_long = false,
                  .refused = {},
                  .around = nullptr,
                  .references = references};
  if (scope.has_robot) scope.sensors = SensorCatalog::OfRobot(*robot, scope.enumerations);

  CheckedTask task;
  task.name = tree.task->text;
  task.doc = tree.doc;
  if (tree.robot) task.robot = tree.robot->text;
  if (robot != nullptr) task.longest_time_step = robot->controller.time_step;
  CheckStartPose(tree, robot, task, diagnostics);
  // The names first, wherever they are declared; then what uses them.
  CheckSensors(tree, scope);
  DeclareFunctions(tree, scope);
  CheckParams(tree, scope, task);
  CheckMemory(tree, scope, task);
  CheckGoals(tree, scope, task);
  CheckFunctions(tree, scope, task);
  CheckMetrics(tree, scope, task);
  CheckEvents(tree, scope, task);
  AddGoalStatements(task);
  AddMemoryOfEnd(tree, task);
  CheckTests(tree, scope, task);
  if (diagnostics.has_errors()) return std::nullopt;

  task.sensors = scope.sensors.list();
  KeepReadSensors(task, diagnostics);
  KeepCalledFunctions(task);
  if (diagnostics.has_errors()) return std::nullopt;
  // A task with errors gets no warnings: many would only be their consequences.
  Warn(task, tree, diagnostics);
  return task;
}

}  // namespace compiler
