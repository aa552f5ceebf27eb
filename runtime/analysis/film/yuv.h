// Pictures as video encoders take them: the brightness of each pixel, and the color of each four.
#pragma once

#include <cstdint>

#include "runtime/analysis/picture/image.h"

namespace runtime {

// Rows of bytes in somebody's memory.
struct Plane {
  uint8_t* data = nullptr;
  int stride = 0;  // from row to row [bytes]
};

struct YuvPlanes {
  Plane luma;
  Plane blue;  // the difference of blue and red from the luma, at half the resolution
  Plane red;
};

// Studio range of BT.601. Precondition: the picture's width and height are even.
void WriteYuv(const Image& picture, const YuvPlanes& out);

}  // namespace runtime
