#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "runtime/learning/q_lambda.h"
#include "runtime/module/context.h"
#include "runtime/module/module.h"
#include "runtime/module/values.h"

namespace runtime {

// The learner: selects actions by Boltzmann's distribution and learns from the rewards they bring
// (runtime/learning/q_lambda.h). Learning rate and temperature fall with the number of finished
// episodes.
//
// The sum of the rewards between start_of_action and the action's end is what the action brought;
// what is paid in answer to `episode_over` belongs to the last action. What is paid before the
// first action is not learned from.
//
// How an episode ends, after someone asked for it for the first time:
//   "original"  when the action that runs is over; its successor's value counts whatever the end
//   "clean"     at once: the action is cut and learned from with what it brought; only a truncated
//               episode's last state has a value
// An episode that diverged ends at once in both, and its last action is not learned from.
class PengQLambda : public Module {
 public:
  PengQLambda(std::string name, const Context& context);

  void Start() override;
  // theta (binary, after a line of text), the random numbers' state and the number of episodes.
  void Save(std::ostream& out) const override;
  // Throws UserError if the stream holds something else, and changes nothing then. Whether what was
  // learned fits the agent shows when the next episode starts.
  void Load(std::istream& in) override;

  // What the present episode's actions have been credited with so far: nothing.
  void ClearTraces() { q_lambda_.ClearTraces(); }
  // As before the first episode: nothing is learned, and the schedules begin anew. The random
  // numbers go on.
  void Forget();
  // From now on it acts as it would next, and learns nothing: the learning rate is 0, and the
  // temperature stays as it is.
  void StopLearning();

  // Whether an episode ends in the middle of an action.
  bool ends_at_once() const;

  bool episode_over() const { return phase_ == Phase::kOver; }
  // Of the episode that runs or ran last: the sum of all rewards, the actions started.
  double episode_return() const { return return_ + reward_; }
  int action_count() const { return actions_; }
  // How the last episode ended. Precondition: one has ended, and no other has started since.
  const EpisodeEnd& episode_end() const { return end_.value(); }
  // Finished episodes, also those of earlier runs that this one goes on from.
  int64_t episode_count() const { return episodes_; }

  const QLambda& q_lambda() const { return q_lambda_; }
  double learning_rate() const;
  double temperature() const;

 private:
  enum class Phase { kOver, kRunning, kEnding };

  void StartOfEpisode();
  void Reward(double reward);
  void EndOfEpisode(EpisodeEnd end);
  void EndOfAction();

  void PrepareTheta(int features);
  void ExecuteAction();
  void NoteEnd(const EpisodeEnd& end);
  void Finish();
  void LearnFromLastAction();
  void LearnAndSelect();
  QLambda::Settings settings() const { return {discount_, trace_decay_, trace_max_}; }

  double discount_ = 0.9;
  double trace_decay_ = 0.9;
  double learning_rate_ = 0.3;
  double learning_rate_decay_ = 0.002;
  double learning_rate_min_ = 0.05;
  double temperature_ = 5;
  double temperature_decay_ = 0.004;
  double trace_max_ = 1;
  std::string episode_end_ = "original";

  QLambda q_lambda_;
  Random random_;
  int64_t episodes_ = 0;

  Phase phase_ = Phase::kOver;
  std::string end_reason_;               // of end_: its task may be swapped before it is over
  std::optional<EpisodeEnd> end_;        // the first one that was asked for in this episode
  std::optional<EpisodeEnd> early_end_;  // asked for before the episode's start has got here
  double reward_ = 0;                    // of the present action, so far
  double return_ = 0;                    // of the episode, without the present action
  int actions_ = 0;

  In<Eigen::VectorXd> features_in_{this, "features"};
  In<int> action_count_in_{this, "action_count"};
  Slot<> start_of_episode_{this, "start_of_episode", Bind<&PengQLambda::StartOfEpisode>{}};
  Slot<double> reward_slot_{this, "reward", Bind<&PengQLambda::Reward>{}};
  Slot<> end_of_action_{this, "end_of_action", Bind<&PengQLambda::EndOfAction>{}};
  Slot<EpisodeEnd> end_of_episode_{this, "end_of_episode", Bind<&PengQLambda::EndOfEpisode>{}};
  Signal<> start_of_action_{this, "start_of_action"};
  Signal<int> execute_{this, "execute"};
  Signal<EpisodeEnd> episode_over_{this, "episode_over"};
};

}  // namespace runtime
