// Peng's Q(lambda) with a linear action-value function and replacing traces:
//
//   Q(x, a) = theta_a . phi(x),   V(x) = max_a Q(x, a)
//
// When action t is over, with R the sum of the rewards paid during it,
//
//   1. action t+1 is selected at x_{t+1}; its phi, Q_{t+1} and V_{t+1} are kept
//   2. e_V = R + gamma V_{t+1} - V_t,   e_Q = R + gamma V_{t+1} - Q_t
//   3. theta += alpha e_V E,   theta_{a_t} += alpha e_Q phi_t
//   4. E <- min(gamma lambda (E + phi_t in row a_t), largest trace), element by element
//
// The discount is per action, however long an action lasts. Q_t and V_t are those of the moment
// when action t was selected: they do not know step 3 of action t-1 yet. Traces are not cut by
// exploration.
//
// Peng and Williams, "Incremental multi-step Q-learning" (1996), as used by Yamaguchi and
// Ogasawara.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "runtime/training/learning/random.h"

namespace runtime {

class QLambda {
 public:
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  struct Settings {
    double discount = 0.9;     // gamma
    double trace_decay = 0.9;  // lambda
    double trace_max = 1;
  };

  QLambda() = default;
  // theta is 0.
  QLambda(int actions, int features);
  // theta has one row for each action, one column for each feature.
  explicit QLambda(Matrix theta);

  int actions() const { return static_cast<int>(theta_.rows()); }
  int features() const { return static_cast<int>(theta_.cols()); }
  const Matrix& theta() const { return theta_; }
  const Matrix& traces() const { return traces_; }

  // Nothing below allocates. `features` are phi at the present state, `random` gives one number for
  // each selection (Boltzmann, `temperature` > 0).

  // Forgets the traces and selects the first action.
  void StartEpisode(const Eigen::VectorXd& features, double temperature, Random& random);

  void ClearTraces();
  // theta and the traces are 0 again.
  void Forget();

  // Selects the next action, then learns from the one that is over. Returns whether it did: what
  // would change theta by more than any value is worth, or by what is not a number, is passed over,
  // so that theta stays finite.
  bool Step(double reward, const Settings& settings, double learning_rate,
            const Eigen::VectorXd& features, double temperature, Random& random);

  // Learns from the action that is over, in a state after which nothing is worth anything (V = 0).
  // Returns as Step().
  bool EndEpisode(double reward, const Settings& settings, double learning_rate);

  // The selected action, the features it was selected by, its value then and that of the best one.
  int action() const { return current_.action; }
  double action_value() const { return current_.action_value; }
  double state_value() const { return current_.state_value; }

 private:
  struct Selection {
    Eigen::VectorXd features;
    int action = 0;
    double action_value = 0;  // Q_t
    double state_value = 0;   // V_t
  };

  void Select(const Eigen::VectorXd& features, double temperature, Random& random);
  bool Learn(double reward, const Settings& settings, double learning_rate, double next_value);

  Matrix theta_;
  Matrix traces_;  // E

  // The actions taken in this episode, each once: all other rows of E are 0 and need no work.
  std::vector<int> traced_actions_;
  std::vector<char> is_traced_;

  Selection current_;
  Selection next_;
  Eigen::VectorXd values_;         // scratch: Q(x, .)
  Eigen::VectorXd probabilities_;  // scratch
};

}  // namespace runtime
