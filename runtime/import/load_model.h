// MuJoCo's model of a file.
#pragma once

#include "runtime/import/model_file.h"
#include "runtime/training/simulation/mujoco_library.h"

namespace runtime {

// What MuJoCo does not know is left out of the file first, with warnings. Throws UserError with
// MuJoCo's own message where the model cannot be made.
MujocoModel LoadModel(ModelFile& file);

// One body that is this mesh (STL or OBJ), `scale` times as large. Throws UserError.
MujocoModel LoadMesh(const std::filesystem::path& file, double scale);

}  // namespace runtime
