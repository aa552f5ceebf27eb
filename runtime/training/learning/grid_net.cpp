#include "runtime/training/learning/grid_net.h"

#include <cassert>
#include <functional>
#include <numeric>
#include <utility>

namespace runtime {
namespace {

constexpr double kDeviationOverSpacing = 0.75 / 2;
constexpr double kIgnored = 1000;

double Spacing(const robot::NetDescription& net, size_t i) {
  return net.counts[i] > 1 ? (net.high[i] - net.low[i]) / (net.counts[i] - 1) : 0;
}

double Center(const robot::NetDescription& net, size_t i, int index) {
  if (net.counts[i] == 1) return (net.low[i] + net.high[i]) / 2;
  return net.low[i] + index * Spacing(net, i);
}

}  // namespace

GaussianNet GridNet(const robot::NetDescription& net, Norm norm) {
  assert(net.kind == robot::NetKind::kGrid);
  const size_t dimensions = net.counts.size();
  const int units = std::accumulate(net.counts.begin(), net.counts.end(), 1, std::multiplies());

  Eigen::MatrixXd centers(units, dimensions);
  Eigen::VectorXd deviations(dimensions);
  int stride = 1;  // units between two neighbors along coordinate i
  for (size_t i = 0; i < dimensions; ++i) {
    const double spacing = Spacing(net, i);
    deviations[i] = spacing > 0 ? kDeviationOverSpacing * spacing : kIgnored;
    if (!net.deviations.empty()) deviations[i] = net.deviations[i];
    for (int k = 0; k < units; ++k) {
      centers(k, i) = Center(net, i, k / stride % net.counts[i]);
    }
    stride *= net.counts[i];
  }
  return GaussianNet(std::move(centers), std::move(deviations), norm);
}

}  // namespace runtime
