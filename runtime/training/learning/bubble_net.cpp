#include "runtime/training/learning/bubble_net.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "runtime/training/learning/random.h"
#include "runtime/training/learning/state.h"

namespace runtime {
namespace {

// The springs have stiffness 1 and act where two spheres overlap, or where a center comes nearer to
// a face than kFaceInset times the radius.
constexpr double kTimeStep = 0.1;
constexpr double kSphereMass = 5;
constexpr double kSphereDamping = 2;
constexpr double kRadiusMass = 5;
constexpr double kRadiusDamping = 10;
constexpr double kInflatingForce = 0.1;  // on the radius, against the largest spring force
constexpr double kFaceInset = 0.2;
constexpr double kDeviationOverRadius = 0.6;

// At rest: the mean of the last kWindow largest accelerations is so small beside the very first
// one.
constexpr size_t kWindow = 100;
constexpr double kRestRatio = 2e-4;
constexpr int kMostSteps = 100000;  // boxes in which the spheres never quite come to rest

// Pairs whose overlap is looked at reach this far beyond contact, so that they need not be looked
// for in every step. Changes the speed, not the result.
constexpr double kSearchMargin = 0.1;

class Bubbles {
 public:
  Bubbles(const Eigen::VectorXd& low, const Eigen::VectorXd& high, int units, uint64_t seed)
      : low_(low), high_(high), positions_(low.size(), units) {
    Random random(seed);
    for (auto sphere : positions_.colwise()) {
      for (Eigen::Index i = 0; i < low.size(); ++i) {
        sphere[i] = low[i] + (high[i] - low[i]) * random.Uniform();
      }
    }
    velocities_.setZero(low.size(), units);
    forces_.setZero(low.size(), units);
    // The original takes the mean over the whole state, in which the net's dimensions are few: a
    // small start, from which the spheres settle better than from a large one.
    const double dimensions = State::Size(static_cast<int>(low.size()));
    radius_ = 0.5 * ((high - low).sum() / dimensions) / std::pow(units, 1 / dimensions);
    FindPairs();
  }

  void Relax() {
    std::array<double, kWindow> window{};
    const double first = Step();
    window[0] = first;
    for (size_t step = 1; step < kMostSteps; ++step) {
      window[step % kWindow] = Step();
      // The mean is only worth taking once in a window: it changes slowly.
      if ((step + 1) % kWindow != 0) continue;
      const double sum = std::accumulate(window.begin(), window.end(), 0.0);
      if (sum < kRestRatio * first * kWindow) return;
    }
  }

  const Eigen::MatrixXd& positions() const { return positions_; }  // one column for each sphere
  double radius() const { return radius_; }

 private:
  // One step of explicit Euler. Returns the largest acceleration of a sphere.
  double Step() {
    if (PairsAreStale()) FindPairs();
    forces_.setZero();
    const double compression = std::max(PushSpheres(), PushFromFaces());

    forces_ = (forces_ - kSphereDamping * velocities_) / kSphereMass;  // accelerations from here on
    const double largest = std::sqrt(forces_.colwise().squaredNorm().maxCoeff());
    positions_ += kTimeStep * velocities_;
    velocities_ += kTimeStep * forces_;

    const double radius_acceleration =
        (kInflatingForce - compression - kRadiusDamping * radius_velocity_) / kRadiusMass;
    radius_ += kTimeStep * radius_velocity_;
    radius_velocity_ += kTimeStep * radius_acceleration;
    return largest;
  }

  // Returns the largest overlap.
  double PushSpheres() {
    const double contact = 2 * radius_;
    const Eigen::Index dimensions = positions_.rows();
    double largest = 0;
    for (const auto& [a, b] : pairs_) {
      const double* position_a = positions_.col(a).data();
      const double* position_b = positions_.col(b).data();
      double square = 0;
      for (Eigen::Index i = 0; i < dimensions; ++i) {
        square += (position_a[i] - position_b[i]) * (position_a[i] - position_b[i]);
      }
      if (square >= contact * contact || square == 0) continue;
      const double distance = std::sqrt(square);
      largest = std::max(largest, contact - distance);
      const double scale = (contact - distance) / distance;
      for (Eigen::Index i = 0; i < dimensions; ++i) {
        const double force = scale * (position_a[i] - position_b[i]);
        forces_(i, a) += force;
        forces_(i, b) -= force;
      }
    }
    return largest;
  }

  // Returns the largest compression of a face's spring.
  double PushFromFaces() {
    double largest = 0;
    for (Eigen::Index k = 0; k < positions_.cols(); ++k) {
      for (Eigen::Index i = 0; i < positions_.rows(); ++i) {
        const double below = std::max(0.0, low_[i] + kFaceInset * radius_ - positions_(i, k));
        const double above = std::max(0.0, positions_(i, k) - (high_[i] - kFaceInset * radius_));
        forces_(i, k) += below - above;
        largest = std::max({largest, below, above});
      }
    }
    return largest;
  }

  void FindPairs() {
    pairs_.clear();
    searched_positions_ = positions_;
    searched_radius_ = radius_;
    const double reach = 2 * radius_ + kSearchMargin;
    for (Eigen::Index a = 0; a < positions_.cols(); ++a) {
      for (Eigen::Index b = a + 1; b < positions_.cols(); ++b) {
        if ((positions_.col(a) - positions_.col(b)).squaredNorm() < reach * reach) {
          pairs_.push_back({a, b});
        }
      }
    }
  }

  // Whether a pair that is not in the list could have come into contact since.
  bool PairsAreStale() const {
    const double moved =
        std::sqrt((positions_ - searched_positions_).colwise().squaredNorm().maxCoeff());
    return 2 * (moved + radius_ - searched_radius_) >= kSearchMargin;
  }

  Eigen::VectorXd low_, high_;
  Eigen::MatrixXd positions_, velocities_, forces_;
  double radius_ = 0;
  double radius_velocity_ = 0;

  std::vector<std::pair<Eigen::Index, Eigen::Index>> pairs_;
  Eigen::MatrixXd searched_positions_;
  double searched_radius_ = 0;
};

}  // namespace

Spheres PackSpheres(const robot::NetDescription& net, uint64_t seed) {
  assert(net.kind == robot::NetKind::kBubble);
  const auto dimensions = static_cast<Eigen::Index>(net.low.size());
  Bubbles bubbles(Eigen::Map<const Eigen::VectorXd>(net.low.data(), dimensions),
                  Eigen::Map<const Eigen::VectorXd>(net.high.data(), dimensions), net.units, seed);
  bubbles.Relax();
  return {bubbles.positions(), bubbles.radius()};
}

GaussianNet BubbleNet(const Spheres& spheres, Norm norm) {
  Eigen::VectorXd deviations =
      Eigen::VectorXd::Constant(spheres.centers.rows(), kDeviationOverRadius * spheres.radius);
  return GaussianNet(spheres.centers.transpose(), std::move(deviations), norm);
}

}  // namespace runtime
