// Random numbers by counting: each is a function of its place alone, so none depends on what else
// is drawn.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace compiler {

// Philox4x32-10 (J. Salmon and others, "Parallel random numbers: as easy as 1, 2, 3", 2011), which
// passes the tests of TestU01. The words of key and counter begin with the lowest.
std::array<uint32_t, 4> Philox(const std::array<uint32_t, 2>& key, std::array<uint32_t, 4> counter);

// Where a goal or a start is drawn; see taskc_goal in taskc/plugin.h.
struct DrawPlace {
  uint64_t seed = 0;
  uint32_t stream = 0;  // the hash of the goal's name
  uint32_t draw = 0;    // how often it was drawn before in this episode
};

// `site`: the number of the random number in the goal's equation; `element`: of that number.
// Between the two, each included, with 53 bits.
double DrawUniform(const DrawPlace& place, uint32_t element, uint32_t site, double low,
                   double high);
// By the Box-Muller transform; never more than 8.572 deviations from the mean.
double DrawNormal(const DrawPlace& place, uint32_t element, uint32_t site, double mean,
                  double deviation);
// 0 .. count - 1
size_t DrawChoice(const DrawPlace& place, uint32_t element, uint32_t site, size_t count);

}  // namespace compiler
