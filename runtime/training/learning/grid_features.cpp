#include "runtime/training/learning/grid_features.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/core/module/connections.h"
#include "runtime/training/learning/grid_net.h"

namespace runtime {
namespace {

constexpr const char* kGaussian = "gaussian";
constexpr const char* kTable = "table";
constexpr double kMostPoints = 100'000;  // for each of them an action has a weight

}  // namespace

GridFeatures::GridFeatures(std::string name, const Context&)
    : Module(std::move(name)), kind_(kGaussian) {
  AddParameter({.name = "kind",
                .doc = "smooth features, or a table with an entry for each point",
                .target = &kind_,
                .choices = {kGaussian, kTable},
                .is_live = false});
  const auto add = [this](const char* parameter, const char* doc, std::vector<double>* target,
                          double minimum) {
    AddParameter(
        {.name = parameter, .doc = doc, .target = target, .minimum = minimum, .is_live = false});
  };
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  add("counts", "points along each element of the observation", &counts_, 1);
  add("low", "where the first of them is", &low_, kNone);
  add("high", "where the last of them is", &high_, kNone);
  add("deviations", "of the smooth features along each element; empty: 3/8 of the spacing",
      &deviations_, 1e-9);
  AddParameter({.name = "max_norm",
                .doc = "measure distances between centers by the max norm",
                .target = &max_norm_,
                .is_live = false});
}

void GridFeatures::CheckParameters() const {
  const size_t size = counts_.size();
  const bool have_same_size = low_.size() == size && high_.size() == size &&
                              (deviations_.empty() || deviations_.size() == size);
  if (size == 0 || !have_same_size) {
    throw UserError(fmt::format(
        "`{0}.counts`, `{0}.low` and `{0}.high` need a number for each element of the observation",
        name()));
  }
  double points = 1;
  for (size_t i = 0; i < size; ++i) {
    points *= counts_[i];
    if (counts_[i] != std::floor(counts_[i])) {
      throw UserError(fmt::format("`{}.counts` are numbers of points, and {} is not whole", name(),
                                  counts_[i]));
    }
    if (!(low_[i] <= high_[i])) {
      throw UserError(
          fmt::format("`{0}.low` has {1}, above the {2} of `{0}.high`", name(), low_[i], high_[i]));
    }
  }
  if (points <= kMostPoints) return;
  throw UserError(fmt::format("`{}` has {:g} points, more than {:g}", name(), points, kMostPoints));
}

const GaussianNet& GridFeatures::Net() {
  if (net_.units() == 0) {
    RequireConnections(*this);
    CheckParameters();
    robot::NetDescription grid;
    grid.low = low_;
    grid.high = high_;
    grid.counts.assign(counts_.begin(), counts_.end());
    grid.deviations = deviations_;
    net_ = GridNet(grid, NormFrom(max_norm_));
    features_.setZero(net_.units());
  }
  return net_;
}

const Eigen::VectorXd& GridFeatures::Features() {
  const Eigen::VectorXd& observation = observation_in_();
  if (observation.size() != net_.dimensions()) {
    throw UserError(fmt::format(
        "`{0}` gets an observation of {1} elements, and `{0}.counts` has {2}: write one for each",
        name(), observation.size(), net_.dimensions()));
  }
  if (kind_ == kGaussian) {
    net_.Evaluate(observation, features_);
  } else {
    features_[entry_] = 0;
    entry_ = NearestPoint(observation);
    features_[entry_] = 1;
  }
  return features_;
}

Eigen::Index GridFeatures::NearestPoint(const Eigen::VectorXd& observation) const {
  Eigen::Index entry = 0, stride = 1;
  for (size_t i = 0; i < counts_.size(); ++i) {
    const double last = counts_[i] - 1;
    const double extent = high_[i] - low_[i];
    const double place =
        extent > 0 ? (observation[static_cast<Eigen::Index>(i)] - low_[i]) / extent : 0;
    entry += stride * static_cast<Eigen::Index>(std::round(std::clamp(place * last, 0.0, last)));
    stride *= static_cast<Eigen::Index>(counts_[i]);
  }
  return entry;
}

}  // namespace runtime
