// Adam, the algorithm of Kingma and Ba (2015): in step t, with the gradient g,
//
//   m = beta_1 m + (1 - beta_1) g,   v = beta_2 v + (1 - beta_2) g^2
//   w = w - alpha m / (1 - beta_1^t) / (sqrt(v / (1 - beta_2^t)) + epsilon)
//
// with beta_1 = 0.9, beta_2 = 0.999, epsilon = 1e-8, as published.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <iosfwd>

namespace runtime {

template <class Scalar>
class Adam {
 public:
  using Vector = Eigen::VectorX<Scalar>;

  Adam() = default;
  explicit Adam(Eigen::Index size) : mean_(Vector::Zero(size)), square_(Vector::Zero(size)) {}

  void Step(const Vector& gradient, Scalar learning_rate, Vector& weights);

  void Save(std::ostream& out) const;
  // The stream has failed where it holds something else than an Adam of this size.
  void Load(std::istream& in);

 private:
  int64_t steps_ = 0;
  Vector mean_;
  Vector square_;
};

}  // namespace runtime
