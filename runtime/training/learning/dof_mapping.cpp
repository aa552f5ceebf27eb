#include "runtime/training/learning/dof_mapping.h"

namespace runtime {

DofMapping::DofMapping(const robot::DofConfiguration& dof, int joints)
    : factors_(Eigen::MatrixXd::Zero(joints, dof.dof())) {
  for (const robot::Coupling& coupling : dof.couplings) {
    factors_(coupling.joint, coupling.coordinate) += coupling.factor;
  }
}

}  // namespace runtime
