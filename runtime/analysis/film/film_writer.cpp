#include "runtime/analysis/film/film_writer.h"

#include <fmt/format.h>

#include "runtime/base/user_error.h"

namespace runtime {

std::unique_ptr<FilmWriter> MakeFilmWriter(const std::filesystem::path& file, int size,
                                           int pictures_per_second) {
  const std::filesystem::path ending = file.extension();
  if (ending == ".gif") return MakeGifWriter(size, pictures_per_second);
  if (ending == ".mp4") return MakeMp4Writer(size, pictures_per_second);
  if (ending == ".webm") return MakeWebmWriter(size, pictures_per_second);
  throw UserError(fmt::format(
      "{}: films are written as .mp4, which everything plays, as .webm, which is smaller, or as "
      ".gif; name a file that ends in one of these",
      file.string()));
}

}  // namespace runtime
