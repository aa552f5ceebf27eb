#include "runtime/training/learning/motion_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <limits>
#include <ostream>

#include "runtime/core/module/connections.h"
#include "runtime/training/learning/saved_matrix.h"

namespace runtime {
namespace {

constexpr const char* kRestart = "restart";
constexpr const char* kContinue = "continue";
constexpr const char* kBest = "best";
constexpr const char* kMiddle = "middle";

constexpr const char* kSearchFormat = "motion_search_2";  // of a checkpoint
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

}  // namespace

MotionSearch::MotionSearch(std::string name, const Context& context)
    : Learner(std::move(name)), seed_(context.seed), best_return_(kNone) {
  AddParameter({.name = "sigma",
                .doc = "first step size, where actions reach from -1 to 1; of the next start",
                .target = &settings_.sigma,
                .minimum = 1e-6,
                .maximum = 10});
  AddParameter({.name = "population",
                .doc = "candidates of a generation; 0: 4 + 3 ln n, for n numbers in an action",
                .target = &settings_.population,
                .minimum = 0,
                .maximum = 100'000});
  AddParameter({.name = "population_growth",
                .doc = "factor of the population with each restart",
                .target = &settings_.growth,
                .minimum = 1,
                .maximum = 10});
  AddParameter({.name = "least_step",
                .doc = "starts again, from elsewhere, where candidates differ by less than this",
                .target = &settings_.least_step,
                .minimum = 0});
  AddParameter({.name = "new_task",
                .doc = "what a swap of the task does: the search starts again around its best "
                       "candidate, or continues where it is",
                .target = &new_task_,
                .choices = {kRestart, kContinue}});
  AddParameter({.name = "plays",
                .doc = "what it does when it does not learn: the best candidate, or the middle of "
                       "the search, which suits a task that draws goals",
                .target = &plays_,
                .choices = {kBest, kMiddle}});
  AddCurve({"best", "", "greatest return so far", &episode_best_});
  AddCurve({"sigma", "", "step size", &episode_sigma_});
  AddCurve({"frequency", "Hz", "of the motion", &episode_frequency_});
  AddCurve({"generation", "", "of the search", &episode_generation_});
  AddCurve({"population", "", "candidates of a generation", &episode_population_});
}

void MotionSearch::Start() {
  RequireConnections(*this);
  if (settings_.population == 1) {
    throw UserError(
        fmt::format("`{}.population` is 1, and candidates need others to be compared "
                    "with: at least 2, or 0",
                    name()));
  }
}

void MotionSearch::SelectFirst() {
  const Eigen::VectorXd& standstill = standstill_in_();
  episode_frequency_ = kNone;
  if (follows()) return CheckFits(action_.size(), standstill.size());
  if (search_.dimensions() == 0) search_ = BoxSearch(standstill, settings_);
  CheckFits(search_.dimensions(), standstill.size());
  is_counted_ = is_learning_;
  if (is_learning_) {
    Random random = EpisodeRandom();
    action_ = search_.Ask(settings_, random);
  } else {
    action_ = plays_ == kBest && best_.size() > 0 ? best_ : search_.middle();
  }
}

void MotionSearch::Execute() {
  execute_(action_);
  episode_frequency_ = frequency_in_();
}

int64_t MotionSearch::EpisodesAlike() const {
  return search_.dimensions() == 0 ? 1 : std::max(1, search_.foreseen(settings_));
}

void MotionSearch::ActLike(const Learner& leader) {
  Random random = EpisodeRandom();
  action_ = dynamic_cast<const MotionSearch&>(leader).search_.Foresee(random);
}

void MotionSearch::Collect(const Learner& follower) {
  Random random = EpisodeRandom();
  action_ = search_.Ask(settings_, random);
  is_counted_ = true;
  episode_frequency_ = dynamic_cast<const MotionSearch&>(follower).episode_frequency_;
}

void MotionSearch::CheckFits(Eigen::Index searched, Eigen::Index present) const {
  if (searched == present) return;
  throw UserError(
      fmt::format("`{}` has searched actions of {} numbers, and those of the agent have "
                  "{}: continue with the action space that it began with, or start over",
                  name(), searched, present));
}

void MotionSearch::FinishEpisode() {
  if (is_counted_) {
    const bool has_diverged = episode_end().kind == EndKind::kDiverged;
    const double value = has_diverged ? kNone : episode_return();
    if (std::isfinite(value) && !(value <= best_return_)) {
      best_return_ = value;
      best_ = action_;
    }
    const int64_t generation = search_.generation();
    search_.Tell(std::isfinite(value) ? -value : std::numeric_limits<double>::infinity());
    if (search_.generation() != generation) NoteNewPolicy();
    is_counted_ = false;
  }
  NoteCurves();
}

void MotionSearch::NoteCurves() {
  episode_best_ = best_return_;
  episode_sigma_ = search_.sigma();
  episode_generation_ = static_cast<double>(search_.generation());
  episode_population_ = search_.population();
}

void MotionSearch::ForgetCredit() {
  is_counted_ = false;
  best_return_ = kNone;
  if (search_.dimensions() == 0) return;
  if (new_task_ == kRestart && best_.size() > 0) {
    search_ = BoxSearch(best_, settings_);
  } else {
    search_.ForgetCosts();
  }
}

void MotionSearch::Forget() {
  is_counted_ = false;
  best_return_ = kNone;
  best_.resize(0);
  search_ = {};
}

void MotionSearch::Save(std::ostream& out) const {
  out << kSearchFormat << ' ' << (search_.dimensions() > 0) << '\n';
  SaveMatrix(out, best_);
  SaveMatrix(out, Eigen::VectorXd::Constant(1, best_return_));
  if (search_.dimensions() > 0) search_.Save(out);
}

void MotionSearch::Load(std::istream& in) {
  std::string format;
  bool has_begun = false;
  in >> format >> has_begun;
  in.get();
  const Eigen::MatrixXd best = LoadMatrix(in);
  const Eigen::MatrixXd best_return = LoadMatrix(in);
  BoxSearch search;
  if (in && has_begun) search.Load(in);
  if (!in || format != kSearchFormat || best_return.size() != 1) {
    throw UserError(fmt::format("the checkpoint of `{}` is damaged or of another version", name()));
  }
  best_ = best.reshaped();
  best_return_ = best_return(0, 0);
  search_ = std::move(search);
}

}  // namespace runtime
