#pragma once

#include <string>

#include "runtime/analysis/picture/palette.h"

namespace runtime {

// The image as a PNG file, without a date or any other text. Equal pixels are equal bytes as long
// as zlib is the same.
std::string EncodePng(const IndexedImage& image);

}  // namespace runtime
