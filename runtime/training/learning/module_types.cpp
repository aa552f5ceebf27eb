#include "runtime/training/learning/module_types.h"

#include "runtime/training/learning/dcob.h"
#include "runtime/training/learning/dof_state.h"
#include "runtime/training/learning/ng_net.h"
#include "runtime/training/learning/peng_q_lambda.h"

namespace runtime {

void AddLearningModules(ModuleTypes& types) {
  types.Add<DofState>("DofState");
  types.Add<NgNet>("NgNet");
  types.Add<Dcob>("Dcob");
  types.Add<PengQLambda>("PengQLambda");
}

}  // namespace runtime
