// Colors as light, and how layers of them cover each other.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace runtime {

// Red, green and blue as amounts of light: the square of what a picture stores. That is close to
// sRGB's own curve, and unlike it needs no function but the square root, which is the same
// everywhere to the last bit.
using Light = Eigen::Vector3d;

Light LightOf(uint32_t rgb);  // 0xrrggbb

// Light that covers part of what is behind it.
struct Layer {
  Light light = Light::Zero();  // already weighted with the cover
  double cover = 0;             // 0 to 1

  // This much light of one color.
  static Layer Of(const Light& light, double cover) { return {cover * light, cover}; }
  Layer Over(const Layer& behind) const;
};

// The four bytes of a pixel: red, green, blue, and alpha, by which they are not multiplied.
void StorePixel(const Layer& layer, uint8_t* rgba);

}  // namespace runtime
