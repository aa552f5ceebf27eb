// A mesh as a link of a robot.
#pragma once

#include <filesystem>
#include <string>

#include "plugins/robot/robot_description.h"

namespace runtime {

struct MeshOptions {
  std::filesystem::path file{};  // STL or OBJ
  double scale = 1;              // 0.001 for a file in millimeters
  double mass = 1;               // [kg]
  int directions = 64;           // in which corners are looked for
};

struct MeshHull {
  robot::Link link;  // of uniform density; its position is in the mesh's frame
  double volume;     // [m^3]
  int vertices;      // of the mesh
  std::string text;  // the link's line in a robot.toml
};

// Throws UserError where the file is no mesh, its points enclose no space, or this program was
// built without MuJoCo.
MeshHull HullOfMesh(const MeshOptions& options);

}  // namespace runtime
