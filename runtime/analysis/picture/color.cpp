#include "runtime/analysis/picture/color.h"

#include <cmath>

namespace runtime {
namespace {

// Of a value from 0 to 1; what is not a number counts as 0.
uint8_t ByteOf(double value) {
  if (!(value > 0)) return 0;
  return static_cast<uint8_t>(std::floor(255 * std::min(value, 1.) + 0.5));
}

}  // namespace

Light LightOf(uint32_t rgb) {
  const Light stored(rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255);
  return (stored / 255).cwiseAbs2();
}

Layer Layer::Over(const Layer& behind) const {
  return {light + (1 - cover) * behind.light, cover + (1 - cover) * behind.cover};
}

void StorePixel(const Layer& layer, uint8_t* rgba) {
  rgba[3] = ByteOf(layer.cover);
  for (int i = 0; i < 3; ++i) {
    rgba[i] = rgba[3] > 0 ? ByteOf(std::sqrt(layer.light[i] / layer.cover)) : 0;
  }
}

}  // namespace runtime
