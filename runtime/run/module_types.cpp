#include "runtime/run/module_types.h"

#include "runtime/learning/module_types.h"
#include "runtime/simulation/robot_environment.h"
#include "runtime/task/universal_task.h"

namespace runtime {

const ModuleTypes& ProgramModuleTypes() {
  static const ModuleTypes types = [] {
    ModuleTypes all;
    all.Add<RobotEnvironment>(RobotEnvironment::kType);
    all.Add<UniversalTask>("UniversalTask");
    AddLearningModules(all);
    return all;
  }();
  return types;
}

}  // namespace runtime
