// Pictures as the file of a film.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "runtime/analysis/picture/image.h"

namespace runtime {

// A player that jumps to a picture decodes all from the key picture before it on.
inline constexpr int kMostBetweenKeys = 100;  // pictures

class FilmWriter {
 public:
  virtual ~FilmWriter() = default;

  // The next picture, opaque, of the size that the film has. Throws UserError.
  virtual void Add(const Image& picture) = 0;
  // The whole file; nothing can be added then. Throws UserError.
  virtual std::string Finish() = 0;
};

// Of films with this many square pictures of `size` pixels a second. Each throws UserError where
// this program was built without what it needs.
std::unique_ptr<FilmWriter> MakeGifWriter(int size, int pictures_per_second);
std::unique_ptr<FilmWriter> MakeMp4Writer(int size, int pictures_per_second);
std::unique_ptr<FilmWriter> MakeWebmWriter(int size, int pictures_per_second);

// The one for files with the ending of this name. Throws UserError where there is none.
std::unique_ptr<FilmWriter> MakeFilmWriter(const std::filesystem::path& file, int size,
                                           int pictures_per_second);

}  // namespace runtime
