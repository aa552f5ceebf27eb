#include "compiler/check/check.h"

#include <algorithm>
#include <cassert>

#include "compiler/check/after_end.h"
#include "compiler/check/declarations.h"
#include "compiler/check/functions.h"
#include "compiler/check/goals.h"
#include "compiler/check/log_table.h"
#include "compiler/check/named_constants.h"
#include "compiler/check/observations.h"
#include "compiler/check/phases.h"
#include "compiler/check/potentials.h"
#include "compiler/check/sensor_use.h"
#include "compiler/check/starts.h"
#include "compiler/check/statements.h"
#include "compiler/check/tables.h"
#include "compiler/check/task_scope.h"
#include "compiler/check/test_blocks.h"
#include "compiler/check/time_functions.h"
#include "compiler/check/warnings.h"
#include "compiler/check/worlds.h"

namespace compiler {
namespace {

bool DeclaresSensors(const SyntaxTree& tree) {
  return std::ranges::any_of(tree.declarations, [](const Declaration& declaration) {
    return std::holds_alternative<SensorDeclaration>(declaration.node);
  });
}

}  // namespace

std::optional<CheckedTask> Check(const SyntaxTree& tree, const robot::RobotDescription* robot,
                                 Diagnostics& diagnostics, References* references,
                                 const world::WorldDescription* world) {
  assert(robot == nullptr || tree.robot);
  const bool knows_robot =
      tree.robot ? robot != nullptr : !tree.lost.has_header && !tree.lost.has_anything;
  NamedConstants constants;
  TaskScope scope{.has_robot = robot != nullptr || !knows_robot,
                  .knows_robot = knows_robot,
                  .knows_names = !tree.lost.has_anything,
                  .knows_functions = !tree.lost.has_anything && !tree.lost.has_imports,
                  .enumerations = EnumerationsOf(robot),
                  .sensors = {},
                  .symbols = {},
                  .constants = constants,
                  .functions = {},
                  .phases = {},
                  .locals = {},
                  .diagnostics = diagnostics,
                  .loop_reads = nullptr,
                  .statements = 0,
                  .is_too_long = false,
                  .refused = {},
                  .around = nullptr,
                  .references = references,
                  .time_functions = nullptr};
  if (robot != nullptr) scope.sensors = SensorCatalog::OfRobot(*robot, scope.enumerations);
  if (!knows_robot && (tree.robot || !DeclaresSensors(tree)))
    scope.sensors = SensorCatalog::OfAnyRobot();
  CheckWorld(tree, world, scope);

  CheckedTask task;
  TimeFunctionTable time_functions(task);
  scope.time_functions = &time_functions;
  if (tree.task) task.name = tree.task->text;
  task.doc = tree.doc;
  if (tree.robot) task.robot = tree.robot->text;
  if (robot != nullptr) {
    task.links = FindEnumeration(scope.enumerations, "link")->members;
    task.joints = FindEnumeration(scope.enumerations, "joint")->members;
    if (const Enumeration* sites = FindEnumeration(scope.enumerations, "site"))
      task.sites = sites->members;
    task.longest_time_step = robot->controller.time_step;
  }
  // The names first, wherever they are declared; then what uses them.
  DeclareFunctions(tree, scope);
  CheckTables(tree, scope);
  CheckConstants(tree, scope);
  CheckSensors(tree, world, scope);
  for (const std::string& word : tree.lost.words)
    if (!scope.sensors.IsRoot(word)) scope.refused.insert(word);
  DeclarePhases(tree, scope, task);
  CheckParams(tree, scope, task);
  CheckMemory(tree, scope, task);
  CheckGoals(tree, scope, task);
  CheckFunctions(tree, scope, task);
  CheckObservations(tree, scope, task);
  CheckMetrics(tree, scope, task);
  LogTable logs(scope, task);
  CheckEvents(tree, logs, scope, task);
  CheckPhases(tree, logs, scope, task);
  CheckPotentials(tree, scope, task);
  CheckStart(tree, robot, logs, scope, task);
  time_functions.AddStatements();
  AddPhaseClock(task);
  AddGoalStatements(task);
  AddMemoryOfEnd(tree, task);
  CheckTests(tree, scope, task);
  task.sensors = scope.sensors.list();
  if (diagnostics.has_errors()) return std::nullopt;

  task.consts = constants.consts;
  task.sets = constants.sets;
  task.tables = constants.tables;
  KeepReadSensors(task, diagnostics);
  KeepCalledFunctions(task);
  if (diagnostics.has_errors()) return std::nullopt;
  // A task with errors gets no warnings: many would only be their consequences.
  Warn(task, tree, diagnostics);
  WarnOfUnusedConstants(tree, constants, diagnostics);
  return task;
}

}  // namespace compiler
