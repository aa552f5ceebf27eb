#include "runtime/training/learning/saved_matrix.h"

#include <algorithm>
#include <cstdint>
#include <istream>
#include <ostream>
#include <vector>

namespace runtime {

void SaveMatrix(std::ostream& out, const Eigen::MatrixXd& matrix) {
  out << matrix.rows() << ' ' << matrix.cols() << '\n';
  out.write(reinterpret_cast<const char*>(matrix.data()),
            static_cast<std::streamsize>(matrix.size() * sizeof(double)));
}

// Read piece by piece: a damaged size allocates little more than the stream holds.
Eigen::MatrixXd LoadMatrix(std::istream& in) {
  constexpr int64_t kMost = int64_t{1} << 28;
  constexpr int64_t kPiece = int64_t{1} << 16;
  int64_t rows = 0, columns = 0;
  in >> rows >> columns;
  const bool is_sound = in && in.get() == '\n' && rows >= 0 && columns >= 0 &&
                        (columns == 0 || rows <= kMost / columns);
  if (!is_sound) {
    in.setstate(std::ios::failbit);
    return {};
  }
  std::vector<double> elements;
  for (int64_t left = rows * columns; left > 0 && in;) {
    const int64_t count = std::min(left, kPiece);
    const size_t known = elements.size();
    elements.resize(known + static_cast<size_t>(count));
    in.read(reinterpret_cast<char*>(elements.data() + known),
            count * static_cast<std::streamsize>(sizeof(double)));
    left -= count;
  }
  if (!in) return {};
  return Eigen::Map<const Eigen::MatrixXd>(elements.data(), rows, columns);
}

}  // namespace runtime
