// What a learned policy computes, as a plain value: from what a robot observes to its joints'
// targets, in steps that any program for neural networks knows. Whoever does one of the steps in an
// agent says what it is (PolicyPart); whoever writes policies for other programs knows nothing of
// agents.
#pragma once

#include <Eigen/Core>
#include <string>
#include <variant>
#include <vector>

namespace runtime {

// One number of a vector.
struct PolicyElement {
  std::string name;
  std::string unit;  // "rad"; "" for a plain number
};

struct PolicyGraph {
  // A vector of floats: the observation, or what a step makes of others before it.
  using Value = size_t;
  static constexpr Value kObservation = 0;

  // (x - mean) * factor, element by element
  struct Normalize {
    Value x;
    Eigen::VectorXf mean;
    Eigen::VectorXf factor;
  };
  // F x + b
  struct Affine {
    Value x;
    Eigen::MatrixXf factors;
    Eigen::VectorXf offsets;
  };
  // tanh(x), element by element
  struct Tanh {
    Value x;
  };
  // min(max(x, low), high), element by element; where there is no limit it is infinite
  struct Clamp {
    Value x;
    Eigen::VectorXf low;
    Eigen::VectorXf high;
  };
  using Step = std::variant<Normalize, Affine, Tanh, Clamp>;

  // A value that is of use outside.
  struct Output {
    std::string name;
    Value value;
    std::vector<PolicyElement> elements;
  };

  Value Add(Step step) {
    steps.push_back(std::move(step));
    return steps.size();
  }

  std::vector<PolicyElement> observation;
  std::vector<Step> steps;  // the first makes value 1, and so on
  Output joint_targets;
  std::vector<Output> others;  // "action": what the action space has got
  int time_steps = 1;          // of the robot's controller, from one decision to the next
};

// A module that does a part of what a policy computes, and nothing that depends on the past: a
// learner from the observation to the action, an action space from there to the joints' targets.
class PolicyPart {
 public:
  virtual ~PolicyPart() = default;

  // Adds what it does with the value `input`, and returns the value that comes out. An action space
  // also says what the numbers of the action are, by an output, and how long targets are held.
  // Throws UserError where there is nothing to add: nothing was learned yet.
  virtual PolicyGraph::Value AddTo(PolicyGraph& graph, PolicyGraph::Value input) const = 0;
};

}  // namespace runtime
