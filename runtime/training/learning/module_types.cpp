#include "runtime/training/learning/module_types.h"

#include "runtime/training/learning/action_table.h"
#include "runtime/training/learning/box_actions.h"
#include "runtime/training/learning/dcob.h"
#include "runtime/training/learning/dof_state.h"
#include "runtime/training/learning/grid_features.h"
#include "runtime/training/learning/joint_offsets.h"
#include "runtime/training/learning/motion_generator.h"
#include "runtime/training/learning/motion_player.h"
#include "runtime/training/learning/motion_search.h"
#include "runtime/training/learning/ng_net.h"
#include "runtime/training/learning/observation.h"
#include "runtime/training/learning/peng_q_lambda.h"
#include "runtime/training/learning/point_dcob.h"
#include "runtime/training/learning/ppo.h"

namespace runtime {

void AddLearningModules(ModuleTypes& types) {
  types.Add<DofState>("DofState");
  types.Add<NgNet>("NgNet");
  types.Add<Observation>("Observation");
  types.Add<Dcob>("Dcob");
  types.Add<PengQLambda>("PengQLambda");
  types.Add<JointOffsets>("JointOffsets");
  types.Add<Ppo>("Ppo");
  types.Add<MotionGenerator>("MotionGenerator");
  types.Add<MotionPlayer>("MotionPlayer");
  types.Add<MotionSearch>("MotionSearch");
  types.Add<GridFeatures>("GridFeatures");
  types.Add<ActionTable>("ActionTable");
  types.Add<BoxActions>("BoxActions");
  types.Add<PointDcob>("PointDcob");
}

}  // namespace runtime
