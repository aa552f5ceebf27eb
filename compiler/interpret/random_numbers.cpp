#include "compiler/interpret/random_numbers.h"

#include <cmath>

namespace compiler {
namespace {

std::array<uint32_t, 4> WordsAt(const DrawPlace& place, uint32_t element, uint32_t site) {
  return Philox({static_cast<uint32_t>(place.seed), static_cast<uint32_t>(place.seed >> 32)},
                {place.draw, element, site, place.stream});
}

// 53 bits as a number from 0 to below 1.
double UnitFrom(uint32_t high, uint32_t low) {
  return ((high >> 5) * 67108864.0 + (low >> 6)) * 0x1p-53;
}

}  // namespace

std::array<uint32_t, 4> Philox(const std::array<uint32_t, 2>& key,
                               std::array<uint32_t, 4> counter) {
  auto [low_key, high_key] = key;
  for (int round = 0; round < 10; ++round) {
    const uint64_t first = uint64_t{0xD2511F53} * counter[0];
    const uint64_t second = uint64_t{0xCD9E8D57} * counter[2];
    counter = {
        static_cast<uint32_t>(second >> 32) ^ counter[1] ^ low_key, static_cast<uint32_t>(second),
        static_cast<uint32_t>(first >> 32) ^ counter[3] ^ high_key, static_cast<uint32_t>(first)};
    low_key += 0x9E3779B9;
    high_key += 0xBB67AE85;
  }
  return counter;
}

double DrawUniform(const DrawPlace& place, uint32_t element, uint32_t site, double low,
                   double high) {
  const auto words = WordsAt(place, element, site);
  const double number = low + (high - low) * UnitFrom(words[0], words[1]);
  // The sum may have been rounded to beyond the end.
  return (number > high) == (low < high) ? high : number;
}

double DrawNormal(const DrawPlace& place, uint32_t element, uint32_t site, double mean,
                  double deviation) {
  constexpr double kTwoPi = 6.283185307179586;
  const auto words = WordsAt(place, element, site);
  const double radius = std::sqrt(-2 * std::log(1 - UnitFrom(words[0], words[1])));
  return mean + deviation * (radius * std::cos(kTwoPi * UnitFrom(words[2], words[3])));
}

size_t DrawChoice(const DrawPlace& place, uint32_t element, uint32_t site, size_t count) {
  const auto words = WordsAt(place, element, site);
  return static_cast<size_t>(UnitFrom(words[0], words[1]) * static_cast<double>(count));
}

}  // namespace compiler
