#include "runtime/analysis/film/yuv.h"

namespace runtime {
namespace {

// In 16 bits of fraction, rounded.
uint8_t Luma(int r, int g, int b) {
  return static_cast<uint8_t>(16 + ((16829 * r + 33039 * g + 6416 * b + 32768) >> 16));
}
uint8_t BlueDifference(int r, int g, int b) {
  return static_cast<uint8_t>(128 + ((-9714 * r - 19070 * g + 28784 * b + 32768) >> 16));
}
uint8_t RedDifference(int r, int g, int b) {
  return static_cast<uint8_t>(128 + ((28784 * r - 24103 * g - 4681 * b + 32768) >> 16));
}

}  // namespace

// Colors at half the resolution: each the mean of four pixels.
void WriteYuv(const Image& picture, const YuvPlanes& out) {
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const uint8_t* const rgb = picture.pixel(x, y);
      out.luma.data[y * out.luma.stride + x] = Luma(rgb[0], rgb[1], rgb[2]);
    }
  }
  for (int y = 0; y < picture.height / 2; ++y) {
    for (int x = 0; x < picture.width / 2; ++x) {
      int rgb[3];
      for (int i = 0; i < 3; ++i) {
        rgb[i] = (picture.pixel(2 * x, 2 * y)[i] + picture.pixel(2 * x + 1, 2 * y)[i] +
                  picture.pixel(2 * x, 2 * y + 1)[i] + picture.pixel(2 * x + 1, 2 * y + 1)[i] + 2) /
                 4;
      }
      out.blue.data[y * out.blue.stride + x] = BlueDifference(rgb[0], rgb[1], rgb[2]);
      out.red.data[y * out.red.stride + x] = RedDifference(rgb[0], rgb[1], rgb[2]);
    }
  }
}

}  // namespace runtime
