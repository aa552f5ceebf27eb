#include "runtime/analysis/behavior/clustering.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "runtime/base/in_parallel.h"

namespace runtime {
namespace {

using Groups = std::vector<std::vector<int>>;

// Equal ones in the order of their first members.
bool LargerFirst(const std::vector<int>& a, const std::vector<int>& b) {
  return a.size() != b.size() ? a.size() > b.size() : a.front() < b.front();
}

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

// ---- Of many things -----------------------------------------------------------------------------

using Distance = std::function<double(int, int)>;

// So many of the things, equally far apart.
std::vector<int> Some(const std::vector<int>& things, size_t count) {
  if (things.size() <= count) return things;
  std::vector<int> some;
  for (size_t i = 0; i < count; ++i) some.push_back(things[i * things.size() / count]);
  return some;
}

Eigen::MatrixXd DistancesBetween(const std::vector<int>& things, const Distance& distance) {
  const auto count = static_cast<Eigen::Index>(things.size());
  Eigen::MatrixXd distances = Eigen::MatrixXd::Zero(count, count);
  InParallel(things.size(), [&](size_t thing) {
    const auto a = static_cast<Eigen::Index>(thing);
    for (Eigen::Index b = a + 1; b < count; ++b) {
      distances(a, b) = distance(things[thing], things[static_cast<size_t>(b)]);
      distances(b, a) = distances(a, b);
    }
  });
  return distances;
}

std::vector<AlikeGroup> ClusterAll(const std::vector<int>& things, const Distance& distance,
                                   double threshold) {
  const Eigen::MatrixXd distances = DistancesBetween(things, distance);
  const auto thing = [&](int place) { return things[static_cast<size_t>(place)]; };
  std::vector<AlikeGroup> groups;
  for (const std::vector<int>& places : Cluster(distances, threshold)) {
    AlikeGroup& group = groups.emplace_back();
    for (const int place : places) group.members.push_back(thing(place));
    group.typical = thing(MostTypical(distances, places));
  }
  return groups;
}

// Puts each of the things into the group of `asked`, members of some groups, that is the nearest.
// Returns for each the number of its group; none where all are as far as the threshold.
std::vector<std::optional<size_t>> NearestGroups(const std::vector<int>& things,
                                                 const std::vector<std::vector<int>>& asked,
                                                 const Distance& distance, double threshold) {
  std::vector<std::optional<size_t>> nearest(things.size());
  InParallel(things.size(), [&](size_t i) {
    double least = threshold;
    for (size_t group = 0; group < asked.size(); ++group) {
      double sum = 0;
      for (const int member : asked[group])
        sum += distance(std::min(things[i], member), std::max(things[i], member));
      const double mean = sum / static_cast<double>(asked[group].size());
      if (!(mean < least)) continue;
      least = mean;
      nearest[i] = group;
    }
  });
  return nearest;
}

// Groups some of the things, and what is like them. Returns those that are like none of them.
std::vector<int> GroupSome(const std::vector<int>& things, const Distance& distance,
                           double threshold, std::vector<AlikeGroup>& groups) {
  const std::vector<int> some = Some(things, kMostClustered);
  std::vector<AlikeGroup> found = ClusterAll(some, distance, threshold);
  std::vector<std::vector<int>> asked;
  for (const AlikeGroup& group : found) asked.push_back(Some(group.members, kMostAsked));
  std::vector<int> others;
  std::ranges::set_difference(things, some, std::back_inserter(others));
  std::vector<int> left;
  const auto nearest = NearestGroups(others, asked, distance, threshold);
  for (size_t i = 0; i < others.size(); ++i) {
    (nearest[i] ? found[*nearest[i]].members : left).push_back(others[i]);
  }
  std::ranges::move(found, std::back_inserter(groups));
  return left;
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
  std::ranges::sort(groups, LargerFirst);
  return groups;
}

std::vector<AlikeGroup> GroupAlike(int count, const Distance& distance, double threshold) {
  std::vector<AlikeGroup> groups;
  std::vector<int> things(static_cast<size_t>(count));
  std::iota(things.begin(), things.end(), 0);
  while (!things.empty()) things = GroupSome(things, distance, threshold, groups);
  for (AlikeGroup& group : groups) std::ranges::sort(group.members);
  std::ranges::sort(groups, LargerFirst, &AlikeGroup::members);
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
