// Matrices in a checkpoint, without a bit lost.
#pragma once

#include <Eigen/Core>
#include <istream>
#include <ostream>

namespace runtime {

// A line with rows and columns, then the elements as the machine has them in memory.
void SaveMatrix(std::ostream& out, const Eigen::MatrixXd& matrix);

// An empty matrix, and the stream has failed, where it holds less than it says.
Eigen::MatrixXd LoadMatrix(std::istream& in);

// The same for a vector of floats or doubles.
template <class Scalar>
void SaveVector(std::ostream& out, const Eigen::VectorX<Scalar>& vector) {
  SaveMatrix(out, vector.template cast<double>());
}

// Into a vector that has the size already; the stream has failed where it holds another one.
template <class Scalar>
void LoadVector(std::istream& in, Eigen::VectorX<Scalar>& vector) {
  const Eigen::MatrixXd loaded = LoadMatrix(in);
  if (loaded.size() == vector.size()) {
    vector = loaded.reshaped().cast<Scalar>();
  } else {
    in.setstate(std::ios::failbit);
  }
}

}  // namespace runtime
