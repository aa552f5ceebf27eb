// What stands for films as WebM in a build without libvpx.
#include "runtime/analysis/film/film_writer.h"
#include "runtime/base/user_error.h"

namespace runtime {

std::unique_ptr<FilmWriter> MakeWebmWriter(int, int) {
  throw UserError(
      "this program was built without libvpx, which encodes .webm: install the package "
      "`libvpx-dev` and build again, or name a file that ends in .mp4 or .gif");
}

}  // namespace runtime
