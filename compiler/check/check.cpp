#include "compiler/check/check.h"

#include <cassert>

#include "compiler/check/declarations.h"
#include "compiler/check/sensor_use.h"
#include "compiler/check/statements.h"
#include "compiler/check/task_scope.h"
#include "compiler/check/warnings.h"

namespace compiler {

std::optional<CheckedTask> Check(const SyntaxTree& tree, const robot::RobotDescription* robot,
                                 Diagnostics& diagnostics) {
  assert(tree.robot.has_value() == (robot != nullptr));
  TaskScope scope{.has_robot = robot != nullptr,
                  .enumerations = EnumerationsOf(robot),
                  .sensors = {},
                  .symbols = {},
                  .lets = {},
                  .diagnostics = diagnostics};
  if (scope.has_robot) scope.sensors = SensorCatalog::OfRobot(scope.enumerations);

  CheckedTask task;
  task.name = tree.task->text;
  task.doc = tree.doc;
  if (tree.robot) task.robot = tree.robot->text;
  CheckStartPose(tree, robot, task, diagnostics);
  // The names first, wherever they are declared; then what uses them.
  CheckSensors(tree, scope);
  CheckParams(tree, scope, task);
  CheckMemory(tree, scope, task);
  CheckMetrics(tree, scope, task);
  CheckEvents(tree, scope, task);
  if (diagnostics.has_errors()) return std::nullopt;

  task.sensors = scope.sensors.list();
  KeepReadSensors(task);
  // A task with errors gets no warnings: many would only be their consequences.
  Warn(task, tree, diagnostics);
  return task;
}

}  // namespace compiler
