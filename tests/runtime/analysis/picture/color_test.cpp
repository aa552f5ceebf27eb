#include "runtime/analysis/picture/color.h"

#include <gmock/gmock.h>

#include <array>
#include <limits>

namespace runtime {
namespace {

using testing::ElementsAre;

std::array<uint8_t, 4> Stored(const Layer& layer) {
  std::array<uint8_t, 4> pixel;
  StorePixel(layer, pixel.data());
  return pixel;
}

TEST(StorePixel, GivesBackEveryColor) {
  for (uint32_t value = 0; value < 256; ++value) {
    const uint32_t rgb = value << 16 | 0x3b00 | (255 - value);
    EXPECT_THAT(Stored(Layer::Of(LightOf(rgb), 1)), ElementsAre(value, 0x3b, 255 - value, 255));
  }
}

TEST(StorePixel, DividesByTheCover) {
  EXPECT_THAT(Stored(Layer::Of(LightOf(0xe8832e), 0.2)), ElementsAre(0xe8, 0x83, 0x2e, 51));
  EXPECT_THAT(Stored(Layer::Of(LightOf(0xe8832e), 0)), ElementsAre(0, 0, 0, 0));
}

TEST(StorePixel, TakesAnyValue) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(Stored({Light(9, nan, -1), 1}), ElementsAre(255, 0, 0, 255));
  EXPECT_THAT(Stored({Light(1, 1, 1), nan}), ElementsAre(0, 0, 0, 0));
}

// Half of white over half of black: three quarters are covered, two thirds of that are white.
TEST(Layer, CoversWhatIsBehind) {
  const Layer both = Layer::Of(Light(1, 1, 1), 0.5).Over(Layer::Of(Light(0, 0, 0), 0.5));
  EXPECT_EQ(both.cover, 0.75);
  EXPECT_EQ(both.light, Light(0.5, 0.5, 0.5));
}

}  // namespace
}  // namespace runtime
