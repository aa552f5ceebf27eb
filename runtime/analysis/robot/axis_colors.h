#pragma once

#include <array>
#include <cstdint>

namespace runtime {

// Of what is along x, y and z in marks over pictures.
inline constexpr std::array<uint32_t, 3> kAxisColors = {0xe03131, 0x2f9e44, 0x1c7ed6};

}  // namespace runtime
