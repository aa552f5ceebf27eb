// Groups of things of which only the distances between them are known.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace runtime {

// Agglomerative clustering by average linkage: begins with a group for each thing and joins the two
// groups whose members are least far apart on average, as long as that is less than `threshold`.
// `distances` is symmetric. Returns the groups, each as ascending indices, the largest first, equal
// ones in the order of their first members.
std::vector<std::vector<int>> Cluster(const Eigen::MatrixXd& distances, double threshold);

// The member that is least far from all others of its group on average.
int MostTypical(const Eigen::MatrixXd& distances, const std::vector<int>& group);

}  // namespace runtime
