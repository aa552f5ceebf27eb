#include "runtime/training/run/return_history.h"

#include <algorithm>
#include <cmath>

namespace runtime {

void ReturnHistory::Add(double episode_return) {
  if (!std::isfinite(episode_return)) return;
  if (parts_.empty() || parts_.back().count == part_size_) {
    if (parts_.size() == kMost) HalveParts();
    parts_.emplace_back();
  }
  parts_.back().sum += episode_return;
  ++parts_.back().count;
}

void ReturnHistory::HalveParts() {
  for (size_t i = 0; i < kMost / 2; ++i) {
    const Part& first = parts_[2 * i];
    const Part& second = parts_[2 * i + 1];
    parts_[i] = {first.sum + second.sum, first.count + second.count};
  }
  parts_.resize(kMost / 2);
  part_size_ *= 2;
}

std::vector<double> ReturnHistory::Means(size_t count) const {
  const size_t size = (parts_.size() + count - 1) / count;  // parts of each mean
  std::vector<double> means;
  for (size_t begin = 0; begin < parts_.size(); begin += size) {
    Part whole;
    for (size_t i = begin; i < std::min(begin + size, parts_.size()); ++i) {
      whole.sum += parts_[i].sum;
      whole.count += parts_[i].count;
    }
    means.push_back(whole.sum / static_cast<double>(whole.count));
  }
  return means;
}

}  // namespace runtime
