#include <fmt/format.h>
#include <gif_lib.h>

#include <utility>
#include <vector>

#include "runtime/analysis/film/film_writer.h"
#include "runtime/analysis/picture/palette.h"
#include "runtime/base/user_error.h"

namespace runtime {
namespace {

constexpr int kColors = IndexedImage::kMostColors;

struct FreeColors {
  void operator()(ColorMapObject* colors) const { GifFreeMapObject(colors); }
};
using Colors = std::unique_ptr<ColorMapObject, FreeColors>;

Colors ColorsOf(const IndexedImage& image) {
  std::vector<GifColorType> colors(kColors);
  for (size_t i = 0; i < image.colors.size(); ++i) {
    const Rgba& color = image.colors[i];
    colors[i] = {color[0], color[1], color[2]};
  }
  return Colors(GifMakeMapObject(kColors, colors.data()));
}

int Append(GifFileType* file, const GifByteType* bytes, int count) {
  static_cast<std::string*>(file->UserData)
      ->append(reinterpret_cast<const char*>(bytes), static_cast<size_t>(count));
  return count;
}

// Each picture with colors of its own.
class GifWriter : public FilmWriter {
 public:
  GifWriter(int size, int pictures_per_second)
      : size_(size), delay_(100 / pictures_per_second), file_(Open()) {
    EGifSetGifVersion(file_, true);
    Check(EGifPutScreenDesc(file_, size, size, 8, 0, nullptr));
    RepeatForEver();
  }
  GifWriter(const GifWriter&) = delete;
  GifWriter& operator=(const GifWriter&) = delete;
  ~GifWriter() override {
    if (file_ != nullptr) EGifCloseFile(file_, nullptr);
  }

  void Add(const Image& picture) override {
    const IndexedImage indexed = ReduceColors(picture);
    GraphicsControlBlock control{};
    control.DelayTime = delay_;
    control.DisposalMode = DISPOSE_DO_NOT;
    control.TransparentColor = NO_TRANSPARENT_COLOR;
    GifByteType bytes[4];
    EGifGCBToExtension(&control, bytes);
    Check(EGifPutExtension(file_, GRAPHICS_EXT_FUNC_CODE, sizeof(bytes), bytes));
    const Colors colors = ColorsOf(indexed);
    Check(EGifPutImageDesc(file_, 0, 0, size_, size_, false, colors.get()));
    for (int y = 0; y < size_; ++y) {
      const auto row = static_cast<size_t>(y) * static_cast<size_t>(size_);
      std::vector<GifPixelType> line(
          indexed.indices.begin() + static_cast<std::ptrdiff_t>(row),
          indexed.indices.begin() + static_cast<std::ptrdiff_t>(row) + size_);
      Check(EGifPutLine(file_, line.data(), size_));
    }
  }

  std::string Finish() override {
    GifFileType* const file = std::exchange(file_, nullptr);
    int error = 0;
    if (EGifCloseFile(file, &error) == GIF_ERROR) Fail(error);
    return std::move(bytes_);
  }

 private:
  GifFileType* Open() {
    int error = 0;
    GifFileType* const file = EGifOpen(&bytes_, Append, &error);
    if (file == nullptr) Fail(error);
    return file;
  }

  void RepeatForEver() {
    const GifByteType for_ever[] = {1, 0, 0};
    Check(EGifPutExtensionLeader(file_, APPLICATION_EXT_FUNC_CODE));
    Check(EGifPutExtensionBlock(file_, 11, "NETSCAPE2.0"));
    Check(EGifPutExtensionBlock(file_, sizeof(for_ever), for_ever));
    Check(EGifPutExtensionTrailer(file_));
  }

  void Check(int result) const {
    if (result == GIF_ERROR) Fail(file_->Error);
  }
  [[noreturn]] static void Fail(int error) {
    throw UserError(fmt::format("cannot write the film: {}", GifErrorString(error)));
  }

  int size_;
  int delay_;  // [10 ms]
  std::string bytes_;
  GifFileType* file_;
};

}  // namespace

std::unique_ptr<FilmWriter> MakeGifWriter(int size, int pictures_per_second) {
  return std::make_unique<GifWriter>(size, pictures_per_second);
}

}  // namespace runtime
