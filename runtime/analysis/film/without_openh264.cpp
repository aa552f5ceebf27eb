// What stands for films as MP4 in a build without OpenH264.
#include "runtime/analysis/film/film_writer.h"
#include "runtime/base/user_error.h"

namespace runtime {

std::unique_ptr<FilmWriter> MakeMp4Writer(int, int) {
  throw UserError(
      "this program was built without OpenH264, which encodes .mp4: install the package "
      "`libopenh264-dev` and build again, or name a file that ends in .webm or .gif");
}

}  // namespace runtime
