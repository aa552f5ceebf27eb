#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "runtime/analysis/picture/image.h"

namespace runtime {

using Rgba = std::array<uint8_t, Image::kChannels>;

// An image as numbers of colours: a quarter of the size, and as a file less than that.
struct IndexedImage {
  static constexpr size_t kMostColours = 256;

  int width;
  int height;
  std::vector<Rgba> colours;     // the first is wholly transparent
  std::vector<uint8_t> indices;  // [y][x]
};

// With the colours that come nearest to the image's own, each the mean of those that it stands for;
// exactly the image where it has few. What is wholly transparent stays so.
IndexedImage ReduceColours(const Image& image);

}  // namespace runtime
