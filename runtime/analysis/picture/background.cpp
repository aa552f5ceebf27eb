#include "runtime/analysis/picture/background.h"

#include "runtime/analysis/picture/color.h"

namespace runtime {
namespace {

constexpr uint32_t kBackground = 0xf3f5f6;  // as on the pages (web/src/style/theme.css)

}  // namespace

void FillBackground(Image& image) {
  const Layer background = Layer::Of(LightOf(kBackground), 1);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      uint8_t* const pixel = image.pixel(x, y);
      const uint32_t rgb = static_cast<uint32_t>(pixel[0] << 16 | pixel[1] << 8 | pixel[2]);
      StorePixel(Layer::Of(LightOf(rgb), pixel[3] / 255.).Over(background), pixel);
    }
  }
}

}  // namespace runtime
