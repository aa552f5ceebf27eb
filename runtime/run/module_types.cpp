#include "runtime/run/module_types.h"

#include "runtime/learning/module_types.h"
#include "runtime/simulation/robot_environment.h"
#include "runtime/task/universal_task.h"

namespace runtime {

void RegisterModuleTypes(ModuleTypes& types) {
  types.Add<RobotEnvironment>("RobotEnvironment");
  types.Add<UniversalTask>("UniversalTask");
  AddLearningModules(types);
}

}  // namespace runtime
