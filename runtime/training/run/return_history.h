// The returns of a run from its start on, as few means in a row, however long the run gets.
#pragma once

#include <cstddef>
#include <vector>

namespace runtime {

class ReturnHistory {
 public:
  static constexpr size_t kMost = 256;  // means that are kept

  // One that is not finite is left out.
  void Add(double episode_return);

  // At most `count` means over as many episodes each, the oldest first; the last one may be of
  // fewer. Precondition: `count` is not 0.
  std::vector<double> Means(size_t count) const;

 private:
  struct Part {
    double sum = 0;
    size_t count = 0;
  };
  void HalveParts();

  size_t part_size_ = 1;  // episodes of each part but the last
  std::vector<Part> parts_;
};

}  // namespace runtime
