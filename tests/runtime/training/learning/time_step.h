#pragma once

namespace runtime {

inline constexpr double kTimeStep = 0.005;  // of the worlds that these tests make up [s]

}  // namespace runtime
