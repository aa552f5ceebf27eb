// A feed-forward network with tanh in its hidden layers:
//
//   h_0 = x,   h_i = tanh(W_i h_{i-1} + b_i),   y = W_n h_{n-1} + b_n
//
// Samples are the columns of a matrix. Float is what robots learn with, double what its derivatives
// are checked with.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "runtime/training/learning/random.h"

namespace runtime {

template <class Scalar>
class Mlp {
 public:
  using Vector = Eigen::VectorX<Scalar>;
  using Matrix = Eigen::MatrixX<Scalar>;

  // What a way through the network leaves for the way back. Used again for as many samples, it
  // allocates nothing.
  struct Pass {
    std::vector<Matrix> outputs;  // of each layer: h_1, ..., y
    std::vector<Matrix> errors;   // derivatives of the loss by W_i h_{i-1} + b_i
  };

  Mlp() = default;
  // `sizes`: of the input, each hidden layer and the output. All weights are 0.
  explicit Mlp(std::vector<int> sizes);

  // W_i normal with the variance 1 / (columns of W_i), the last one times `output_scale`; b_i = 0.
  void Randomize(Scalar output_scale, Random& random);

  const std::vector<int>& sizes() const { return sizes_; }
  int inputs() const { return sizes_.empty() ? 0 : sizes_.front(); }
  int outputs() const { return sizes_.empty() ? 0 : sizes_.back(); }

  // Of all layers, one after the other: the columns of W_i, then b_i.
  const Vector& weights() const { return weights_; }
  Vector& weights() { return weights_; }

  // W_i and b_i; i counts from 0 here.
  size_t layer_count() const { return layers_.size(); }
  Eigen::Map<const Matrix> LayerWeights(size_t i) const { return WeightsOf(layers_[i]); }
  Eigen::Map<const Vector> LayerBiases(size_t i) const { return BiasesOf(layers_[i]); }

  // y; it belongs to `pass`.
  const Matrix& Forward(const Matrix& inputs, Pass& pass) const;
  // The derivative by the weights of a loss whose derivative by y is `output_errors`. `inputs` and
  // `pass` are those of Forward().
  void Backward(const Matrix& inputs, const Matrix& output_errors, Pass& pass,
                Vector& gradient) const;

 private:
  struct Layer {
    int inputs;
    int outputs;
    Eigen::Index start;  // of W in the weights
    Eigen::Index bias() const { return start + Eigen::Index{inputs} * outputs; }
  };

  Eigen::Map<const Matrix> WeightsOf(const Layer& layer) const {
    return {weights_.data() + layer.start, layer.outputs, layer.inputs};
  }
  Eigen::Map<const Vector> BiasesOf(const Layer& layer) const {
    return {weights_.data() + layer.bias(), layer.outputs};
  }

  std::vector<int> sizes_;
  std::vector<Layer> layers_;
  Vector weights_;
};

}  // namespace runtime
