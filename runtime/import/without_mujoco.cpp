// What stands for the importer in a build without MuJoCo.
#include "runtime/base/user_error.h"
#include "runtime/import/import_robot.h"
#include "runtime/import/mesh_hull.h"

namespace runtime {

namespace {

UserError WithoutMujoco() {
  return UserError(
      "this program was built without MuJoCo, which reads such files: install the package "
      "`libmujoco-dev`, and build again");
}

}  // namespace

ImportedRobot ImportRobot(const ImportOptions&) { throw WithoutMujoco(); }

MeshHull HullOfMesh(const MeshOptions&) { throw WithoutMujoco(); }

}  // namespace runtime
