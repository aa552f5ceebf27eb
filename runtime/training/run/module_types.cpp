#include "runtime/training/run/module_types.h"

#include "runtime/core/task/universal_task.h"
#include "runtime/training/environment/socket_environment.h"
#include "runtime/training/learning/module_types.h"
#include "runtime/training/signal/signal_generator.h"
#include "runtime/training/simulation/robot_environment.h"

namespace runtime {

const ModuleTypes& ProgramModuleTypes() {
  static const ModuleTypes types = [] {
    ModuleTypes all;
    all.Add<RobotEnvironment>(RobotEnvironment::kType);
    all.Add<SocketEnvironment>(SocketEnvironment::kType);
    all.Add<UniversalTask>("UniversalTask");
    all.Add<SignalGenerator>(SignalGenerator::kType);
    AddLearningModules(all);
    return all;
  }();
  return types;
}

}  // namespace runtime
