#include "runtime/training/learning/running_moments.h"

#include <cassert>
#include <cmath>
#include <istream>
#include <ostream>

#include "runtime/training/learning/saved_matrix.h"

namespace runtime {

void RunningMoments::Add(const Eigen::Ref<const Eigen::VectorXd>& vector) {
  assert(vector.size() == mean_.size());
  ++count_;
  for (Eigen::Index i = 0; i < mean_.size(); ++i) {
    const double difference = vector[i] - mean_[i];
    mean_[i] += difference / static_cast<double>(count_);
    squares_[i] += difference * (vector[i] - mean_[i]);
  }
}

double RunningMoments::Deviation(Eigen::Index i) const {
  constexpr double kLeastVariance = 1e-8;
  if (count_ == 0) return 1;
  return std::sqrt(squares_[i] / static_cast<double>(count_) + kLeastVariance);
}

void RunningMoments::Save(std::ostream& out) const {
  out << count_ << ' ';
  SaveVector(out, mean_);
  SaveVector(out, squares_);
}

void RunningMoments::Load(std::istream& in) {
  in >> count_;
  LoadVector(in, mean_);
  LoadVector(in, squares_);
}

}  // namespace runtime
