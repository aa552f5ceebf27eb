#include "runtime/analysis/picture/palette.h"

#include <algorithm>
#include <span>

namespace runtime {
namespace {

constexpr size_t kChannels = Image::kChannels;

// A color of the image, as it adds to what is behind it: red, green and blue are multiplied by
// alpha. Differences of such colors are what is seen, on a white page and on a dark one.
struct Color {
  std::array<int64_t, kChannels> values{};
  int64_t count = 0;   // of pixels
  uint32_t pixel = 0;  // its bytes
};

uint32_t Pack(const uint8_t* pixel) {
  return static_cast<uint32_t>(pixel[0]) << 24 | static_cast<uint32_t>(pixel[1]) << 16 |
         static_cast<uint32_t>(pixel[2]) << 8 | pixel[3];
}

Color ColorOf(uint32_t pixel) {
  const int64_t alpha = pixel & 255;
  Color color{{}, 0, pixel};
  for (size_t i = 0; i < 3; ++i) {
    color.values[i] = ((pixel >> (24 - 8 * i) & 255) * alpha + 127) / 255;
  }
  color.values[3] = alpha;
  return color;
}

// All colors that are seen, with their numbers of pixels.
std::vector<Color> ColorsOf(const std::vector<uint32_t>& pixels) {
  std::vector<uint32_t> sorted = pixels;
  std::ranges::sort(sorted);
  std::vector<Color> colors;
  for (const uint32_t pixel : sorted) {
    if ((pixel & 255) == 0) continue;
    if (colors.empty() || colors.back().pixel != pixel) colors.push_back(ColorOf(pixel));
    ++colors.back().count;
  }
  return colors;
}

// Colors that become one.
class Bin {
 public:
  explicit Bin(std::span<Color> colors) : colors_(colors) {
    std::array<int64_t, kChannels> squares{};
    for (const Color& color : colors) {
      count_ += color.count;
      for (size_t i = 0; i < kChannels; ++i) {
        sums_[i] += color.count * color.values[i];
        squares[i] += color.count * color.values[i] * color.values[i];
      }
    }
    for (size_t i = 0; i < kChannels; ++i) {
      const double sum = static_cast<double>(sums_[i]);
      const double error =
          static_cast<double>(squares[i]) - sum * sum / static_cast<double>(count_);
      if (error <= error_) continue;
      error_ = error;
      widest_ = i;
    }
  }

  // Sum of the squares by which the colors differ from their mean, in the channel where it is
  // largest.
  double error() const { return error_; }
  std::span<Color> colors() const { return colors_; }

  // The colors below the mean of that channel, and the others.
  std::pair<Bin, Bin> Split() const {
    const auto upper = std::partition(colors_.begin(), colors_.end(), [&](const Color& color) {
      return color.values[widest_] * count_ < sums_[widest_];
    });
    const auto lower = static_cast<size_t>(upper - colors_.begin());
    return {Bin(colors_.first(lower)), Bin(colors_.subspan(lower))};
  }

  Rgba Mean() const {
    Rgba mean;
    for (size_t i = 0; i < 3; ++i) {
      mean[i] = static_cast<uint8_t>(
          std::min<int64_t>(255, (2 * 255 * sums_[i] + sums_[3]) / (2 * sums_[3])));
    }
    mean[3] = static_cast<uint8_t>((2 * sums_[3] + count_) / (2 * count_));
    return mean;
  }

 private:
  std::span<Color> colors_;
  int64_t count_ = 0;
  std::array<int64_t, kChannels> sums_{};
  double error_ = 0;
  size_t widest_ = 0;
};

// The bin that is least like its mean is split until there are enough.
std::vector<Bin> BinsOf(std::vector<Color>& colors) {
  std::vector<Bin> bins;
  if (!colors.empty()) bins.emplace_back(colors);
  while (!bins.empty() && bins.size() < IndexedImage::kMostColors - 1) {
    const auto worst = std::ranges::max_element(bins, {}, &Bin::error);
    if (worst->error() <= 0) break;
    auto [lower, upper] = worst->Split();
    *worst = lower;
    bins.push_back(upper);
  }
  return bins;
}

}  // namespace

IndexedImage ReduceColors(const Image& image) {
  std::vector<uint32_t> pixels;
  for (size_t i = 0; i < image.bytes.size(); i += kChannels) {
    pixels.push_back(Pack(image.bytes.data() + i));
  }
  std::vector<Color> colors = ColorsOf(pixels);
  IndexedImage reduced{image.width, image.height, {Rgba{}}, {}};
  std::vector<std::pair<uint32_t, uint8_t>> index_of;  // ascending
  for (const Bin& bin : BinsOf(colors)) {
    for (const Color& color : bin.colors()) {
      index_of.emplace_back(color.pixel, static_cast<uint8_t>(reduced.colors.size()));
    }
    reduced.colors.push_back(bin.Mean());
  }
  std::ranges::sort(index_of);
  for (const uint32_t pixel : pixels) {
    const auto found = std::ranges::lower_bound(index_of, pixel, {},
                                                [](const auto& entry) { return entry.first; });
    reduced.indices.push_back((pixel & 255) == 0 ? 0 : found->second);
  }
  return reduced;
}

}  // namespace runtime
