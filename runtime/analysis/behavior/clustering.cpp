#include "runtime/analysis/behavior/clustering.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace runtime {
namespace {

using Groups = std::vector<std::vector<int>>;

// The two groups that are nearest to each other, if they are nearer than `threshold`.
std::optional<std::pair<size_t, size_t>> NearestTwo(const Eigen::MatrixXd& distances,
                                                    double threshold) {
  std::optional<std::pair<size_t, size_t>> nearest;
  double least = threshold;
  for (Eigen::Index a = 0; a < distances.rows(); ++a) {
    for (Eigen::Index b = a + 1; b < distances.cols(); ++b) {
      if (!(distances(a, b) < least)) continue;
      least = distances(a, b);
      nearest = {static_cast<size_t>(a), static_cast<size_t>(b)};
    }
  }
  return nearest;
}

// Joins group `b` to group `a`. The distance of the joint group to another one is the mean over all
// pairs, so that of both parts, weighted by their sizes; `b` is then infinitely far from all.
void Join(size_t a, size_t b, Groups& groups, Eigen::MatrixXd& distances) {
  const auto size_a = static_cast<double>(groups[a].size());
  const auto size_b = static_cast<double>(groups[b].size());
  const auto row_a = static_cast<Eigen::Index>(a);
  const auto row_b = static_cast<Eigen::Index>(b);
  const Eigen::RowVectorXd joint =
      (size_a * distances.row(row_a) + size_b * distances.row(row_b)) / (size_a + size_b);
  distances.row(row_a) = joint;
  distances.col(row_a) = joint.transpose();
  distances.row(row_b).setConstant(std::numeric_limits<double>::infinity());
  distances.col(row_b).setConstant(std::numeric_limits<double>::infinity());
  groups[a].insert(groups[a].end(), groups[b].begin(), groups[b].end());
  groups[b].clear();
}

}  // namespace

Groups Cluster(const Eigen::MatrixXd& distances, double threshold) {
  Groups groups;
  for (int i = 0; i < distances.rows(); ++i) groups.push_back({i});
  Eigen::MatrixXd between = distances;
  while (const auto nearest = NearestTwo(between, threshold)) {
    Join(nearest->first, nearest->second, groups, between);
  }
  std::erase_if(groups, [](const auto& group) { return group.empty(); });
  for (auto& group : groups) std::ranges::sort(group);
  std::ranges::sort(groups, [](const auto& a, const auto& b) {
    return a.size() != b.size() ? a.size() > b.size() : a.front() < b.front();
  });
  return groups;
}

int MostTypical(const Eigen::MatrixXd& distances, const std::vector<int>& group) {
  const auto sum = [&](int member) {
    double total = 0;
    for (const int other : group) total += distances(member, other);
    return total;
  };
  return *std::ranges::min_element(group, {}, sum);
}

}  // namespace runtime
