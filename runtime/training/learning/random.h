// The source of all randomness in learning: equal seeds give equal numbers on every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <istream>
#include <numbers>
#include <ostream>
#include <random>

namespace runtime {

// The 64-bit Mersenne twister, whose numbers and text form the C++ standard fixes to the last bit.
// The standard's distributions are not used: they differ between libraries.
class Random {
 public:
  explicit Random(uint64_t seed) : engine_(seed) {}

  // Uniform in [0, 1), with 53 random bits.
  double Uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

  // Standard normal, of two uniform numbers (Box and Muller), so that nothing is kept but the
  // engine.
  double Normal() {
    const double length = std::sqrt(-2 * std::log(1 - Uniform()));
    return length * std::cos(2 * std::numbers::pi * Uniform());
  }

  friend std::ostream& operator<<(std::ostream& out, const Random& random) {
    return out << random.engine_;
  }
  friend std::istream& operator>>(std::istream& in, Random& random) { return in >> random.engine_; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace runtime
