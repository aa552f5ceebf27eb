// Groups of things of which only the distances between them are known.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace runtime {

// Agglomerative clustering by average linkage: begins with a group for each thing and joins the two
// groups whose members are least far apart on average, as long as that is less than `threshold`.
// `distances` is symmetric. Returns the groups, each as ascending indices, the largest first, equal
// ones in the order of their first members.
std::vector<std::vector<int>> Cluster(const Eigen::MatrixXd& distances, double threshold);

// What is alike, by the numbers of the things.
struct AlikeGroup {
  std::vector<int> members;  // ascending
  int typical = 0;           // the member that is least far from the others on average
};

// Groups the things 0 .. `count` - 1 as Cluster() does, the largest group first. As that takes the
// cube of their number, no more than kMostClustered are clustered: of more, so many from all over;
// each of the others joins the group that is least far from it on average, by up to kMostAsked of
// its members, or, where all are as far as the threshold, is grouped with the rest in the same way.
// `distance` is called in several threads, the smaller number first.
inline constexpr int kMostClustered = 400;
inline constexpr size_t kMostAsked = 20;
std::vector<AlikeGroup> GroupAlike(int count, const std::function<double(int, int)>& distance,
                                   double threshold);

// The member that is least far from all others of its group on average.
int MostTypical(const Eigen::MatrixXd& distances, const std::vector<int>& group);

}  // namespace runtime
