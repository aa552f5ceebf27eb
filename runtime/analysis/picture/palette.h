#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "runtime/analysis/picture/image.h"

namespace runtime {

using Rgba = std::array<uint8_t, Image::kChannels>;

// An image as numbers of colors: a quarter of the size, and as a file less than that.
struct IndexedImage {
  static constexpr size_t kMostColors = 256;

  int width;
  int height;
  std::vector<Rgba> colors;      // the first is wholly transparent
  std::vector<uint8_t> indices;  // [y][x]
};

// With the colors that come nearest to the image's own, each the mean of those that it stands for;
// exactly the image where it has few. What is wholly transparent stays so.
IndexedImage ReduceColors(const Image& image);

}  // namespace runtime
