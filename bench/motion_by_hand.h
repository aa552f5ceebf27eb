// What bench/tasks/table.task pays, written by hand: what a table is compared with.
#pragma once

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

namespace runtime {

class MotionByHand {
 public:
  static constexpr int kJoints = 17;
  static constexpr int kLinks = 18;

  explicit MotionByHand(const std::string& csv) {
    std::ifstream file(csv);
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
      std::istringstream cells(line);
      for (std::string cell; std::getline(cells, cell, ',');) numbers_.push_back(std::stod(cell));
      times_.push_back(numbers_[times_.size() * kColumns]);
    }
    for (size_t row = 0; row < times_.size(); ++row)
      for (size_t i = 1; i <= kJoints; ++i) numbers_[row * kColumns + i] *= std::numbers::pi / 180;
  }

  // Per second. `positions`: x, y, z of each link; the feet are the links 12 and 17.
  double Reward(double time, const double* angles, const double* positions) const {
    const double length = times_.back() - times_.front();
    const double at = time - std::floor(time / length) * length;
    const auto next = std::upper_bound(times_.begin(), times_.end(), at);
    if (next == times_.end())
      return RewardAt(times_.size() - 1, times_.size() - 1, 0, angles, positions);
    const size_t to = static_cast<size_t>(next - times_.begin());
    const double share = (at - times_[to - 1]) / (times_[to] - times_[to - 1]);
    return RewardAt(to - 1, to, share, angles, positions);
  }

 private:
  static constexpr size_t kColumns = 1 + kJoints + 3 * kLinks + 7;  // the last are the trunk's

  double RewardAt(size_t from, size_t to, double share, const double* angles,
                  const double* positions) const {
    const double* a = &numbers_[from * kColumns + 1];
    const double* b = &numbers_[to * kColumns + 1];
    double squares = 0;
    for (int i = 0; i < kJoints; ++i) {
      const double miss = angles[i] - (a[i] + (b[i] - a[i]) * share);
      squares += miss * miss;
    }
    double reward = -std::sqrt(squares);
    for (const int link : {12, 17}) {
      squares = 0;
      for (int i = 3 * link; i < 3 * link + 3; ++i) {
        const double place = a[kJoints + i] + (b[kJoints + i] - a[kJoints + i]) * share;
        squares += (positions[i] - place) * (positions[i] - place);
      }
      reward -= std::sqrt(squares);
    }
    return reward;
  }

  std::vector<double> times_;
  std::vector<double> numbers_;  // row by row
};

}  // namespace runtime
