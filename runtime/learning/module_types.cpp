#include "runtime/learning/module_types.h"

#include "runtime/learning/dcob.h"
#include "runtime/learning/dof_state.h"
#include "runtime/learning/ng_net.h"
#include "runtime/learning/peng_q_lambda.h"

namespace runtime {

void AddLearningModules(ModuleTypes& types) {
  types.Add<DofState>("DofState");
  types.Add<NgNet>("NgNet");
  types.Add<Dcob>("Dcob");
  types.Add<PengQLambda>("PengQLambda");
}

}  // namespace runtime
