#include "runtime/analysis/picture/palette.h"

#include <gtest/gtest.h>

#include <cmath>

namespace runtime {
namespace {

Rgba PixelOf(const IndexedImage& image, size_t i) { return image.colors[image.indices[i]]; }
Rgba PixelOf(const Image& image, size_t i) {
  const uint8_t* pixel = image.bytes.data() + i * Image::kChannels;
  return {pixel[0], pixel[1], pixel[2], pixel[3]};
}

// Pixel (x, y) is orange, x times as light, and covers y / 63.
Image Shades() {
  Image image(64, 64);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      uint8_t* pixel = image.pixel(x, y);
      pixel[0] = static_cast<uint8_t>(4 * x);
      pixel[1] = static_cast<uint8_t>(2 * x);
      pixel[3] = static_cast<uint8_t>(255 * y / 63);
    }
  }
  return image;
}

TEST(ReduceColors, KeepsFewColorsAsTheyAre) {
  Image image(16, 10);
  for (int i = 0; i < 160; ++i) {
    uint8_t* pixel = image.pixel(i % 16, i / 16);
    pixel[0] = static_cast<uint8_t>(i);
    pixel[1] = static_cast<uint8_t>(255 - i);
    pixel[3] = 255;
  }
  const IndexedImage reduced = ReduceColors(image);
  for (size_t i = 0; i < 160; ++i) EXPECT_EQ(PixelOf(reduced, i), PixelOf(image, i)) << i;
}

TEST(ReduceColors, KeepsWhatIsTransparent) {
  const Image image = Shades();
  const IndexedImage reduced = ReduceColors(image);
  EXPECT_EQ(reduced.colors[0], Rgba{});
  for (size_t i = 0; i < 64 * 64; ++i) {
    EXPECT_EQ(reduced.indices[i] == 0, PixelOf(image, i)[3] == 0) << i;
  }
}

TEST(ReduceColors, ComesCloseToManyColors) {
  const Image image = Shades();
  const IndexedImage reduced = ReduceColors(image);
  EXPECT_EQ(reduced.colors.size(), IndexedImage::kMostColors);
  double sum = 0;  // of squared differences of red, as seen on black
  for (size_t i = 0; i < 64 * 64; ++i) {
    const Rgba a = PixelOf(image, i), b = PixelOf(reduced, i);
    const double difference = (a[0] * a[3] - b[0] * b[3]) / 255.;
    sum += difference * difference;
  }
  EXPECT_LT(std::sqrt(sum / (64 * 64)), 6);
}

TEST(ReduceColors, OfNothingIsNothing) { EXPECT_EQ(ReduceColors(Image(3, 2)).colors.size(), 1u); }

}  // namespace
}  // namespace runtime
