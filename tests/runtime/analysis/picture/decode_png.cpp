#include "tests/runtime/analysis/picture/decode_png.h"

#include <gtest/gtest.h>
#include <png.h>

namespace runtime {

Image DecodePng(const std::string& file) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  EXPECT_TRUE(png_image_begin_read_from_memory(&header, file.data(), file.size()))
      << header.message;
  header.format = PNG_FORMAT_RGBA;
  Image image(static_cast<int>(header.width), static_cast<int>(header.height));
  EXPECT_TRUE(png_image_finish_read(&header, nullptr, image.bytes.data(), 0, nullptr));
  return image;
}

}  // namespace runtime
