// What a run knows of the module that learns, and all that one learner has in common with another.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "runtime/core/module/episode_seed.h"
#include "runtime/core/module/module.h"
#include "runtime/core/module/values.h"

namespace runtime {

// A number that a learner shows of each episode: a learning rate, a loss. It refers to a member
// variable of the learner, which holds it when the episode is over; not a number: there is none.
struct LearnerCurve {
  std::string name;
  std::string unit;  // "" for a plain number
  std::string doc;
  const double* value;
};

// Selects actions and learns from the rewards that they bring. A run, its checkpoints, changes
// while it runs and its evaluation know learners by this class only: whatever module is one can be
// trained.
//
// A learner says by the functions below what it does; its parameters are its settings, and Save()
// and Load() hold all that its next episodes depend on, random numbers too. What an action is,
// stays between it and the action space: it adds a signal that carries it, an index (Signal<int>)
// or a vector (Signal<const Eigen::VectorXd&>), and whatever in ports it needs.
//
// The course of an episode is the same for all. The sum of the rewards between start_of_action and
// the action's end is what the action brought; what is paid in answer to `episode_over` belongs to
// the last action, what is paid before the first one to none. An episode that someone has asked to
// end does so when the action that runs is over, or in the middle of it (ends_at_once()); the first
// who asks says why. One that has diverged ends at once, and its last action is not learned from.
class Learner : public Module {
 public:
  static constexpr const char* kRole = "learner";  // for ModuleGraph::FindOnly()

  explicit Learner(std::string name) : Module(std::move(name)) {}

  // ---- the episode that runs or ran last

  bool episode_over() const { return phase_ == Phase::kOver; }
  // The sum of all rewards, the actions started.
  double episode_return() const { return return_ + reward_; }
  int action_count() const { return actions_; }
  // Actions that were not learned from, because what would have been learned was not finite or too
  // large: only a learner that diverges, or a reward that is not one, brings that about.
  int passed_over_count() const { return passed_over_; }
  // How it ended. Precondition: an episode has ended, and no other has started since.
  const EpisodeEnd& episode_end() const { return end_.value(); }
  // The same ones from the first episode to the last.
  const std::vector<LearnerCurve>& curves() const { return curves_; }

  // ---- what a run tells a learner, never from inside an event

  // gamma: what the value of the state that an action leads to counts for that action, from 0 to 1.
  // A member variable, which may change between two time steps; tasks read it when an action or an
  // episode is over.
  virtual const double& discount() const = 0;
  // Whether an episode ends in the middle of an action.
  virtual bool ends_at_once() const = 0;
  // The task has changed: no reward from now on is for an action that this episode has begun with.
  virtual void ForgetCredit() = 0;
  // As before the first episode: nothing is learned, and schedules restart. The random numbers
  // go on.
  virtual void Forget() = 0;
  // From now on it acts as it would in the next episode, and learns nothing.
  virtual void StopLearning() = 0;
  // The number in the run of the episode that starts next; else it is one more than the last.
  void SetNextEpisode(int64_t number) { episode_ = number - 1; }
  // The episode that runs will not come to its end: another one starts next.
  void Abandon();

  // ---- episodes side by side
  //
  // A learner that learns between episodes only acts in some of them by the same: these can be run
  // before their turn, each in a graph of its own where another object of the class follows this
  // one. What they brought is taken over in their order, so that all is as if this learner had run
  // them itself, one after the other.

  // Whether an episode is changed by what is learned in it: then there is nothing to run ahead.
  virtual bool learns_within_episodes() const { return true; }
  // How many episodes from the next one on, that included, are acted in by the same, as far as can
  // be told now. 1 where only this learner itself can run the next one.
  virtual int64_t EpisodesAlike() const { return 1; }
  // Another number whenever what it acts by has changed: what was run ahead before is void then.
  int64_t policy_number() const { return policy_number_; }

  // In the episode `number`, its next one, this object acts as `leader` would, and learns nothing.
  // What an earlier episode left behind, which may not have come to its end, is forgotten.
  // Precondition: `leader` is of the same class and has the same parameters.
  void Follow(const Learner& leader, int64_t number);
  // As if this learner had run the episode that `follower`, which acted as it would, has run.
  void TakeOver(const Learner& follower);

 protected:
  // ---- what a learner does. Within an episode nothing here allocates once one has been run.

  // An episode starts: selects its first action. Throws UserError where what was learned does not
  // fit the agent.
  virtual void SelectFirst() = 0;
  // Sends the selected action to the action space.
  virtual void Execute() = 0;
  // An action is over: learns from what it brought, and selects the next one.
  virtual void LearnAndSelect(double reward) = 0;
  // The episode is over, and with it an action that brought `reward`.
  virtual void LearnFromEnd(double reward, const EpisodeEnd& end) = 0;
  // The episode is over, and was learned from if it could be: brings up to date what the curves
  // show and what counts episodes, and does what is learned between episodes. Not called where this
  // object follows another one.
  virtual void FinishEpisode() {}

  // Of Follow() and TakeOver(): what the class adds. Only where it does not learn within episodes.
  virtual void ActLike(const Learner& /*leader*/) {}
  virtual void Collect(const Learner& /*follower*/) {}

  bool follows() const { return follows_; }
  // The number in the run of the episode that runs or ran last.
  int64_t episode() const { return episode_; }
  void NoteNewPolicy() { ++policy_number_; }

  // The action that is over was not learned from (passed_over_count()).
  void NotePassedOver() { ++passed_over_; }

  void AddCurve(LearnerCurve curve) { curves_.push_back(std::move(curve)); }

 private:
  enum class Phase { kOver, kRunning, kEnding };

  void StartOfEpisode();
  void Reward(double reward);
  void EndOfAction();
  void EndOfEpisode(EpisodeEnd end);

  void StartAction();
  void NoteEnd(const EpisodeEnd& end);
  void Finish();

  std::vector<LearnerCurve> curves_;
  bool follows_ = false;
  int64_t episode_ = 0;
  int64_t policy_number_ = 0;
  Phase phase_ = Phase::kOver;
  std::string end_reason_;               // of end_: its task may be swapped before it is over
  std::optional<EpisodeEnd> end_;        // the first one that was asked for in this episode
  std::optional<EpisodeEnd> early_end_;  // asked for before the episode's start has got here
  double reward_ = 0;                    // of the present action, so far
  double return_ = 0;                    // of the episode, without the present action
  int actions_ = 0;
  int passed_over_ = 0;

  Slot<> start_of_episode_{this, "start_of_episode", Bind<&Learner::StartOfEpisode>{}};
  Slot<double> reward_slot_{this, "reward", Bind<&Learner::Reward>{}};
  Slot<> end_of_action_{this, "end_of_action", Bind<&Learner::EndOfAction>{}};
  Slot<EpisodeEnd> end_of_episode_{this, "end_of_episode", Bind<&Learner::EndOfEpisode>{}};
  Signal<> start_of_action_{this, "start_of_action"};
  Signal<EpisodeEnd> episode_over_{this, "episode_over"};
};

}  // namespace runtime
