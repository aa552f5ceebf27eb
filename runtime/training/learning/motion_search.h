#pragma once

#include <cstdint>
#include <string>

#include "runtime/core/module/context.h"
#include "runtime/training/learning/box_search.h"
#include "runtime/training/learning/learner.h"
#include "runtime/training/learning/random.h"

namespace runtime {

// Searches for the action, a vector in the box [-1, 1]^n, that brings the greatest return if it is
// taken throughout an episode: by CMA-ES with restarts (runtime/training/learning/box_search.h).
// Each episode tries one candidate. Its actions are whole motions (motion_player.h), so that it
// finds what a task pays for; it never looks at the robot's state.
//
// A candidate with which the simulation diverges is worse than any other. Where a task changes
// while a candidate is tried, that candidate is not counted; and the returns of those before it do
// not count any more, by the parameter `new_task`:
//   "restart"   the search starts again around the best candidate
//   "continue"  it goes on where it is, with this generation from its beginning
class MotionSearch : public Learner {
 public:
  MotionSearch(std::string name, const Context& context);

  void Start() override;
  void Save(std::ostream& out) const override;
  // Throws UserError if the stream holds something else, and changes nothing then. Whether what was
  // found fits the agent shows when the next episode starts.
  void Load(std::istream& in) override;

  const double& discount() const override { return discount_; }
  bool ends_at_once() const override { return true; }
  void ForgetCredit() override;
  void Forget() override;
  // From now on all episodes repeat the best candidate, or the middle of the search, by the
  // parameter `plays`.
  void StopLearning() override { is_learning_ = false; }

  bool learns_within_episodes() const override { return false; }
  // The rest of the generation.
  int64_t EpisodesAlike() const override;

  const Eigen::VectorXd& action() const { return action_; }
  // The best candidate, and its return; not a number where none was tried since the task is what it
  // is.
  const Eigen::VectorXd& best() const { return best_; }
  double best_return() const { return best_return_; }
  const BoxSearch& search() const { return search_; }

 private:
  void SelectFirst() override;
  void Execute() override;
  void LearnAndSelect(double) override {}
  void LearnFromEnd(double, const EpisodeEnd&) override {}
  void FinishEpisode() override;
  void ActLike(const Learner& leader) override;
  void Collect(const Learner& follower) override;

  Random EpisodeRandom() const { return Random(EpisodeSeed(seed_, episode())); }
  // Of actions with so many numbers.
  void CheckFits(Eigen::Index searched, Eigen::Index present) const;
  void NoteCurves();

  const double discount_ = 1;  // what counts is the return, a plain sum
  BoxSearch::Settings settings_{.least_step = 1e-3};
  std::string new_task_ = "restart";
  std::string plays_ = "best";

  const uint64_t seed_;
  BoxSearch search_;
  Eigen::VectorXd best_;
  double best_return_;
  Eigen::VectorXd action_;
  bool is_learning_ = true;
  bool is_counted_ = false;  // the candidate that is being tried

  // Of the episode that ran last.
  double episode_best_ = 0, episode_sigma_ = 0, episode_frequency_ = 0;
  double episode_generation_ = 0, episode_population_ = 0;

  In<Eigen::VectorXd> standstill_in_{this, "standstill"};
  In<double> frequency_in_{this, "frequency"};
  Signal<const Eigen::VectorXd&> execute_{this, "execute"};
};

}  // namespace runtime
