#include "runtime/analysis/picture/png.h"

#include <gmock/gmock.h>

#include "tests/runtime/analysis/picture/decode_png.h"

namespace runtime {
namespace {

// The names of the file's parts.
std::vector<std::string> ChunksOf(const std::string& file) {
  std::vector<std::string> chunks;
  for (size_t i = 8; i + 8 <= file.size();) {
    size_t length = 0;
    for (size_t k = 0; k < 4; ++k) length = length << 8 | static_cast<uint8_t>(file[i + k]);
    chunks.push_back(file.substr(i + 4, 4));
    i += 12 + length;
  }
  return chunks;
}

TEST(EncodePng, HoldsThePixels) {
  const IndexedImage image{3, 2, {{}, {1, 2, 3, 4}, {250, 251, 252, 255}}, {0, 1, 2, 2, 1, 0}};
  const Image decoded = DecodePng(EncodePng(image));
  ASSERT_EQ(decoded.width, 3);
  ASSERT_EQ(decoded.height, 2);
  for (int i = 0; i < 6; ++i) {
    const Rgba& expected = image.colors[image.indices[static_cast<size_t>(i)]];
    const uint8_t* pixel = decoded.pixel(i % 3, i / 3);
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), pixel)) << i;
  }
}

TEST(EncodePng, HoldsNothingElse) {
  EXPECT_THAT(ChunksOf(EncodePng({1, 1, {{}, {1, 2, 3, 4}}, {1}})),
              testing::ElementsAre("IHDR", "PLTE", "tRNS", "IDAT", "IEND"));
}

}  // namespace
}  // namespace runtime
