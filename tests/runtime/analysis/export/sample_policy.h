#pragma once

#include <limits>

#include "runtime/analysis/export/policy.h"

namespace runtime {

// Two joints follow two numbers that are observed:
//   action = tanh(1 2 0.5) of ((pitch - 0.25) / 0.5, rate / 2), each within 10
// and the targets are 0.5 and -0.5 times the action, the second not below -0.125.
inline ExportedPolicy SamplePolicy() {
  using Eigen::MatrixXf, Eigen::VectorXf;
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  ExportedPolicy policy;
  policy.facts = {{"task", "balance"}, {"run", "a\\"}};
  policy.seconds_per_decision = 0.04;
  PolicyGraph& graph = policy.graph;
  graph.observation = {{"tilt.pitch", "rad"}, {"tilt.pitch", "rad/s"}};
  auto value = graph.Add(PolicyGraph::Normalize{0, VectorXf{{0.25, 0}}, VectorXf{{2, 0.5}}});
  value = graph.Add(PolicyGraph::Clamp{value, VectorXf{{-10, -10}}, VectorXf{{10, 10}}});
  value = graph.Add(PolicyGraph::Affine{value, MatrixXf{{1, 2}}, VectorXf{{0.5}}});
  value = graph.Add(PolicyGraph::Tanh{value});
  graph.others = {{"action", value, {{"left", ""}}}};
  value = graph.Add(PolicyGraph::Affine{value, MatrixXf{{0.5}, {-0.5}}, VectorXf{{0, 0}}});
  value = graph.Add(
      PolicyGraph::Clamp{value, VectorXf{{-kInfinity, -0.125}}, VectorXf{{kInfinity, kInfinity}}});
  graph.result = {"joint_targets", value, {{"left", "rad"}, {"right*/", "rad"}}};
  return policy;
}

// A period of 2 s.
inline PolicyMotion SampleMotion() {
  return {.is_periodic = true,
          .frequency = 0.5,
          .shape = Eigen::MatrixXd{{0.25, 1, 0.5}, {0, 0, -0.5}},
          .low = Eigen::VectorXd{{-1, -0.25}},
          .high = Eigen::VectorXd{{1, 0.25}}};
}

}  // namespace runtime
