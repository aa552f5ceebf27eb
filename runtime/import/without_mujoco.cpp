// What stands for the importer in a build without MuJoCo.
#include "runtime/base/user_error.h"
#include "runtime/import/import_robot.h"

namespace runtime {

ImportedRobot ImportRobot(const ImportOptions&) {
  throw UserError(
      "this program was built without MuJoCo, which reads such files: install the package "
      "`libmujoco-dev`, and build again");
}

}  // namespace runtime
