// What a learned policy computes, as a plain value: from what a robot observes to its joints'
// targets, in steps that any program for neural networks knows. Whoever does one of the steps in an
// agent says what it is (PolicyPart, MotionPart); whoever writes policies for other programs knows
// nothing of agents.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace runtime {

// One number of a vector.
struct PolicyElement {
  std::string name;
  std::string unit;  // "rad"; "" for a plain number
};

// Where joints are to be at the time t [s] since a motion began, without a look at the robot. With
// the columns s of `shape`, each an element for each joint, it is periodic:
//
//   s_0 + sum_k (s_{2k-1} sin(2 pi k f t) + s_{2k} cos(2 pi k f t))
//
// or is done once, by a Catmull-Rom spline that begins in s_0 and ends in s_K, both with rate 0:
// it is in s_i at t = i / (K f). In either case it goes no farther than the stops.
struct PolicyMotion {
  bool is_periodic = true;
  double frequency = 0;   // f [Hz]
  Eigen::MatrixXd shape;  // joints x columns [rad]
  Eigen::VectorXd low;    // the stops [rad]
  Eigen::VectorXd high;
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
  // The joints' targets; where there is a motion, how far these are from it in each time step until
  // the next decision, within the stops.
  Output result;
  std::optional<PolicyMotion> motion;
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

// A module whose joint targets are such a motion.
class MotionPart {
 public:
  virtual ~MotionPart() = default;

  // As it is in the present episode: a motion begins where the robot does.
  virtual PolicyMotion AsFunctionOfTime() const = 0;
};

}  // namespace runtime
