// MuJoCo's model of a file.
#pragma once

#include <mujoco/mujoco.h>

#include <memory>

#include "runtime/import/model_file.h"

namespace runtime {

struct DeleteModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct DeleteData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using MujocoModel = std::unique_ptr<mjModel, DeleteModel>;
using MujocoData = std::unique_ptr<mjData, DeleteData>;

// What MuJoCo does not know is left out of the file first, with warnings. Throws UserError with
// MuJoCo's own message where the model cannot be made.
MujocoModel LoadModel(ModelFile& file);

// One body that is this mesh (STL or OBJ), `scale` times as large. Throws UserError.
MujocoModel LoadMesh(const std::filesystem::path& file, double scale);

}  // namespace runtime
