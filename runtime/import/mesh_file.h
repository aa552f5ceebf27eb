// The bytes of meshes as MuJoCo reads them.
#pragma once

#include <filesystem>
#include <string>

namespace runtime {

// Of a mesh in this place, in the format of its ending; STL that is written as text becomes binary.
// An empty place: a cube of 5 cm, as STL. Throws UserError where it cannot be read.
std::string MeshBytes(const std::filesystem::path& place);

}  // namespace runtime
