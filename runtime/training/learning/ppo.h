#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/core/module/context.h"
#include "runtime/core/module/values.h"
#include "runtime/training/learning/learner.h"
#include "runtime/training/learning/policy_graph.h"
#include "runtime/training/learning/ppo_update.h"

namespace runtime {

// Proximal policy optimization (runtime/training/learning/ppo_update.h). Actions are vectors, drawn
// from a normal distribution whose mean is what a network makes of the observation. What is drawn
// may be correlated with what was drawn for the action before, of the same episode; the update
// takes it for independent.
//
// The policy changes between episodes only: after the first one with which there are at least
// `batch` decisions that were not learned from. An episode ends at once. What its last state is
// worth counts where a limit has cut it off, and not where it has succeeded or failed; a diverged
// episode is not learned from at all.
class Ppo : public Learner, public PolicyPart {
 public:
  Ppo(std::string name, const Context& context);

  void Start() override;
  void Save(std::ostream& out) const override;
  // Throws UserError if the stream holds something else, and changes nothing then. Whether what was
  // learned fits the agent shows when the next episode starts.
  void Load(std::istream& in) override;

  const double& discount() const override { return settings_.discount; }
  bool ends_at_once() const override { return true; }
  // Decisions of another task, and the action that runs, are not learned from. What else belongs to
  // the task is kept or forgotten as the parameters `new_task_...` say; the policy is kept.
  void ForgetCredit() override;
  void Forget() override;
  // The action is the mean, and nothing is collected.
  void StopLearning() override { learns_ = false; }

  // The mean action. What an observation is limited to before anything else is left out: a number
  // as large is far beyond the limit of what is normalized.
  PolicyGraph::Value AddTo(PolicyGraph& graph, PolicyGraph::Value observation) const override;

  bool learns_within_episodes() const override { return false; }
  // Until the batch is full, if episodes last as long as those before.
  int64_t EpisodesAlike() const override;

  const PpoState& state() const { return state_; }

 private:
  void SelectFirst() override;
  void Execute() override { execute_(action_out_); }
  void LearnAndSelect(double reward) override;
  void LearnFromEnd(double reward, const EpisodeEnd& end) override;
  void FinishEpisode() override;
  void ActLike(const Learner& leader) override;
  void Collect(const Learner& follower) override;

  std::vector<int> HiddenSizes() const;
  // Makes the networks before the first episode. Throws UserError where what was learned has other
  // sizes than the observation and the action.
  void PrepareState();
  void Observe();
  void DrawNoise(double correlation);
  void Select();
  void Note(double reward);

  std::vector<double> hidden_ = {64, 64};
  int batch_ = 1024;
  std::string deviation_mode_;
  std::string new_task_value_, new_task_scale_, new_task_optimizers_;
  double noise_correlation_ = 0;
  PpoSettings settings_;

  const uint64_t seed_;
  Random random_;            // for what is learned
  Random action_random_{0};  // for the actions of one episode
  PpoState state_;
  PpoUpdate update_;
  bool learns_ = true;
  bool has_credit_ = false;       // the action that runs is learned from
  double episode_decisions_ = 0;  // of an episode, on average in the last batch; 0: none yet

  Eigen::VectorXf observation_;  // that the action was selected for
  Eigen::MatrixXf normalized_;   // the same for the network, a column
  Mlp<float>::Pass pass_;
  Eigen::VectorXf noise_;  // of the action, in units of the deviations
  Eigen::VectorXf action_;
  Eigen::VectorXd action_out_;
  PpoFigures shown_;

  In<Eigen::VectorXd> observation_in_{this, "observation"};
  In<int> action_size_in_{this, "action_size"};
  Signal<const Eigen::VectorXd&> execute_{this, "execute"};
};

}  // namespace runtime
