// Values as sensors and params may have them: everyday ones, and those at the edges.
#pragma once

#include <limits>

#include "compiler/check/value.h"
#include "tests/compiler/random/random_numbers.h"

namespace compiler {

inline double RandomReal(RandomNumbers& random) {
  using Limits = std::numeric_limits<double>;
  if (random.OneIn(4)) {
    return random.OneOf({0.0, -0.0, 1.0, -1.0, 0.5, 1e308, -1e308, 1e-308, Limits::denorm_min(),
                         -Limits::denorm_min(), Limits::infinity(), -Limits::infinity(),
                         Limits::quiet_NaN(), 3.141592653589793, -3.141592653589793, 1e16});
  }
  return static_cast<double>(random.Bits() >> 32) / (1 << random.OneOf({20, 26, 30}));
}

inline int64_t RandomInteger(RandomNumbers& random) {
  using Limits = std::numeric_limits<int64_t>;
  if (random.OneIn(4)) {
    return random.OneOf<int64_t>({0, 1, -1, Limits::max(), Limits::min(), int64_t{1} << 53});
  }
  return random.OneIn(4) ? random.Bits() : int64_t{random.Below(21)} - 10;
}

inline Value RandomValue(const Type& type, RandomNumbers& random) {
  if (type.scalar == Scalar::kReal) {
    Reals reals(type.size());
    for (double& real : reals) real = RandomReal(random);
    return reals;
  }
  Integers integers(type.size());
  for (int64_t& integer : integers) {
    integer = type.scalar == Scalar::kBool ? random.Below(2) : RandomInteger(random);
  }
  return integers;
}

}  // namespace compiler
