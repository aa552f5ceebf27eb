#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace runtime {

struct Image {
  static constexpr int kChannels = 4;  // red, green, blue, alpha (not premultiplied)

  Image(int w, int h)
      : width(w), height(h), bytes(static_cast<size_t>(w) * static_cast<size_t>(h) * kChannels) {}

  uint8_t* pixel(int x, int y) { return bytes.data() + Offset(x, y); }
  const uint8_t* pixel(int x, int y) const { return bytes.data() + Offset(x, y); }

  int width;
  int height;
  std::vector<uint8_t> bytes;  // [y][x][channel], the top row first

 private:
  size_t Offset(int x, int y) const {
    return (static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)) *
           kChannels;
  }
};

}  // namespace runtime
