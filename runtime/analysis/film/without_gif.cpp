// What stands for films as GIF in a build without giflib.
#include "runtime/analysis/film/film_writer.h"
#include "runtime/base/user_error.h"

namespace runtime {

std::unique_ptr<FilmWriter> MakeGifWriter(int, int) {
  throw UserError(
      "this program was built without giflib, which writes .gif: install the package `libgif-dev` "
      "and build again, or name a file that ends in .mp4 or .webm");
}

}  // namespace runtime
