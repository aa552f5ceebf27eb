#include "runtime/training/learning/adam.h"

#include <cassert>
#include <cmath>
#include <istream>
#include <ostream>

#include "runtime/training/learning/saved_matrix.h"

namespace runtime {
namespace {

constexpr double kMeanDecay = 0.9;
constexpr double kSquareDecay = 0.999;
constexpr double kEpsilon = 1e-8;

}  // namespace

template <class Scalar>
void Adam<Scalar>::Step(const Vector& gradient, Scalar learning_rate, Vector& weights) {
  assert(gradient.size() == mean_.size() && weights.size() == mean_.size());
  ++steps_;
  const auto t = static_cast<double>(steps_);
  constexpr auto kBeta1 = static_cast<Scalar>(kMeanDecay);
  constexpr auto kBeta2 = static_cast<Scalar>(kSquareDecay);
  mean_ = kBeta1 * mean_ + (1 - kBeta1) * gradient;
  square_.array() = kBeta2 * square_.array() + (1 - kBeta2) * gradient.array().square();
  const auto rate = static_cast<Scalar>(learning_rate / (1 - std::pow(kMeanDecay, t)));
  const auto scale = static_cast<Scalar>(1 / std::sqrt(1 - std::pow(kSquareDecay, t)));
  weights.array() -=
      rate * mean_.array() / (scale * square_.array().sqrt() + static_cast<Scalar>(kEpsilon));
}

template <class Scalar>
void Adam<Scalar>::Save(std::ostream& out) const {
  out << steps_ << ' ';
  SaveVector(out, mean_);
  SaveVector(out, square_);
}

template <class Scalar>
void Adam<Scalar>::Load(std::istream& in) {
  in >> steps_;
  LoadVector(in, mean_);
  LoadVector(in, square_);
}

template class Adam<float>;
template class Adam<double>;

}  // namespace runtime
