#include "runtime/analysis/picture/png.h"

#include <png.h>

#include <memory>
#include <stdexcept>

namespace runtime {
namespace {

void Append(png_structp png, png_bytep bytes, size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<char*>(bytes), count);
}

[[noreturn]] void Fail(png_structp, const char* message) {
  throw std::runtime_error(std::string("cannot encode a picture: ") + message);
}

struct Writer {
  Writer() : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, Fail, nullptr)) {
    if (png) info = png_create_info_struct(png);
    if (!info) throw std::bad_alloc();
  }
  ~Writer() { png_destroy_write_struct(&png, &info); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  png_structp png = nullptr;
  png_infop info = nullptr;
};

void SetColors(const std::vector<Rgba>& colors, Writer& writer) {
  std::vector<png_color> opaque;
  std::vector<png_byte> alphas;
  for (const Rgba& color : colors) {
    opaque.push_back({color[0], color[1], color[2]});
    alphas.push_back(color[3]);
  }
  const int count = static_cast<int>(colors.size());
  png_set_PLTE(writer.png, writer.info, opaque.data(), count);
  png_set_tRNS(writer.png, writer.info, alphas.data(), count, nullptr);
}

}  // namespace

std::string EncodePng(const IndexedImage& image) {
  std::string file;
  Writer writer;
  png_set_write_fn(writer.png, &file, Append, nullptr);
  png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(image.width),
               static_cast<png_uint_32>(image.height), 8, PNG_COLOR_TYPE_PALETTE,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  SetColors(image.colors, writer);
  png_set_filter(writer.png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
  png_set_compression_level(writer.png, 9);
  png_write_info(writer.png, writer.info);
  for (int y = 0; y < image.height; ++y) {
    png_write_row(writer.png,
                  image.indices.data() + static_cast<size_t>(y) * static_cast<size_t>(image.width));
  }
  png_write_end(writer.png, nullptr);
  return file;
}

}  // namespace runtime
