#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <iosfwd>

namespace runtime {

// Mean and variance of each element of all vectors so far (Welford), and vectors measured by them:
// (x - mean) / deviation. Before the first vector the mean is 0 and the deviation 1.
class RunningMoments {
 public:
  RunningMoments() = default;
  explicit RunningMoments(Eigen::Index size)
      : mean_(Eigen::VectorXd::Zero(size)), squares_(Eigen::VectorXd::Zero(size)) {}

  void Add(const Eigen::Ref<const Eigen::VectorXd>& vector);

  Eigen::Index size() const { return mean_.size(); }
  double Mean(Eigen::Index i) const { return mean_[i]; }
  // Never 0: an element that has not varied is measured by 1e-4.
  double Deviation(Eigen::Index i) const;

  void Save(std::ostream& out) const;
  // The stream has failed where it holds something else than the moments of as many elements.
  void Load(std::istream& in);

 private:
  int64_t count_ = 0;
  Eigen::VectorXd mean_;
  Eigen::VectorXd squares_;  // sums of the squared differences from the mean
};

}  // namespace runtime
