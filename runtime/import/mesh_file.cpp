#include "runtime/import/mesh_file.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <sstream>
#include <string_view>
#include <vector>

#include "base/file/read.h"
#include "runtime/base/user_error.h"
#include "runtime/import/model_file.h"

namespace runtime {
namespace {

using Corner = std::array<float, 3>;

// Of triangles with these corners, three for each.
std::string BinaryStl(const std::vector<Corner>& corners) {
  constexpr size_t kHeader = 80;
  std::string bytes(kHeader, '\0');
  const auto append = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  append(static_cast<uint32_t>(corners.size() / 3));
  for (size_t i = 0; i + 2 < corners.size(); i += 3) {
    append(Corner{});  // the normal, which nobody reads
    for (size_t k = 0; k < 3; ++k) append(corners[i + k]);
    append(uint16_t{0});
  }
  return bytes;
}

std::string CubeOf5Centimeters() {
  constexpr float kHalf = 0.025F;
  constexpr std::array<std::array<int, 3>, 12> kTriangles = {{{0, 1, 3},
                                                              {0, 3, 2},
                                                              {4, 6, 7},
                                                              {4, 7, 5},
                                                              {0, 4, 5},
                                                              {0, 5, 1},
                                                              {2, 3, 7},
                                                              {2, 7, 6},
                                                              {0, 2, 6},
                                                              {0, 6, 4},
                                                              {1, 5, 7},
                                                              {1, 7, 3}}};
  std::vector<Corner> corners;
  for (const auto& triangle : kTriangles) {
    for (const int corner : triangle) {
      const auto side = [&](int axis) { return (corner & axis) != 0 ? kHalf : -kHalf; };
      corners.push_back({side(4), side(2), side(1)});
    }
  }
  return BinaryStl(corners);
}

// "solid NAME / facet normal ... / vertex 0 0 1 ...": a binary file may begin with "solid", too,
// and has bytes that no text has.
bool IsTextStl(std::string_view bytes) {
  const std::string_view begin = bytes.substr(0, 1000);
  return bytes.starts_with("solid") && begin.find("facet") != begin.npos &&
         begin.find('\0') == begin.npos;
}

std::vector<Corner> CornersOf(const std::string& text) {
  std::vector<Corner> corners;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    Corner corner{};
    if (word == "vertex" && words >> corner[0] >> corner[1] >> corner[2]) corners.push_back(corner);
    words.clear();
  }
  return corners;
}

}  // namespace

std::string MeshBytes(const std::filesystem::path& place) {
  if (place.empty()) return CubeOf5Centimeters();
  file::Reading reading = file::Read(place);
  if (!reading.problem.empty()) {
    throw UserError(fmt::format("{}: cannot read the mesh: {}", place.string(), reading.problem));
  }
  const bool is_text = ExtensionOf(place.string()) == ".stl" && IsTextStl(reading.bytes);
  return is_text ? BinaryStl(CornersOf(reading.bytes)) : std::move(reading.bytes);
}

}  // namespace runtime
