#include "runtime/training/learning/mlp.h"

#include <cassert>
#include <cmath>
#include <utility>

namespace runtime {
namespace {

// How Eigen splits a long sum of products depends on the sizes of the processor's caches, and with
// it the last bit of the sum. These sizes are used whatever the machine has.
void FixOrderOfSums() { Eigen::setCpuCacheSizes(32 << 10, 256 << 10, 2 << 20); }

}  // namespace

template <class Scalar>
Mlp<Scalar>::Mlp(std::vector<int> sizes) : sizes_(std::move(sizes)) {
  assert(sizes_.size() >= 2);
  FixOrderOfSums();
  Eigen::Index count = 0;
  for (size_t i = 0; i + 1 < sizes_.size(); ++i) {
    layers_.push_back({sizes_[i], sizes_[i + 1], count});
    count = layers_.back().bias() + sizes_[i + 1];
  }
  weights_.setZero(count);
}

template <class Scalar>
void Mlp<Scalar>::Randomize(Scalar output_scale, Random& random) {
  weights_.setZero();
  for (const Layer& layer : layers_) {
    const bool is_last = &layer == &layers_.back();
    const double deviation = (is_last ? output_scale : Scalar(1)) / std::sqrt(layer.inputs);
    for (Eigen::Index i = layer.start; i < layer.bias(); ++i) {
      weights_[i] = static_cast<Scalar>(deviation * random.Normal());
    }
  }
}

template <class Scalar>
const Eigen::MatrixX<Scalar>& Mlp<Scalar>::Forward(const Matrix& inputs, Pass& pass) const {
  assert(inputs.rows() == this->inputs());
  pass.outputs.resize(layers_.size());
  const Matrix* previous = &inputs;
  for (size_t i = 0; i < layers_.size(); ++i) {
    Matrix& output = pass.outputs[i];
    output.noalias() = WeightsOf(layers_[i]) * *previous;
    output.colwise() += BiasesOf(layers_[i]);
    if (i + 1 < layers_.size()) output.array() = output.array().tanh();
    previous = &output;
  }
  return *previous;
}

template <class Scalar>
void Mlp<Scalar>::Backward(const Matrix& inputs, const Matrix& output_errors, Pass& pass,
                           Vector& gradient) const {
  gradient.resize(weights_.size());
  pass.errors.resize(layers_.size());
  pass.errors.back() = output_errors;
  for (size_t i = layers_.size(); i-- > 0;) {
    const Layer& layer = layers_[i];
    const Matrix& errors = pass.errors[i];
    const Matrix& layer_inputs = i > 0 ? pass.outputs[i - 1] : inputs;
    Eigen::Map<Matrix> weights(gradient.data() + layer.start, layer.outputs, layer.inputs);
    weights.noalias() = errors * layer_inputs.transpose();
    gradient.segment(layer.bias(), layer.outputs) = errors.rowwise().sum();
    if (i == 0) break;
    Matrix& previous = pass.errors[i - 1];
    previous.noalias() = WeightsOf(layer).transpose() * errors;
    previous.array() *= Scalar(1) - layer_inputs.array().square();
  }
}

template class Mlp<float>;
template class Mlp<double>;

}  // namespace runtime
