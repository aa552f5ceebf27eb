#include "runtime/training/learning/ppo.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <ostream>

#include "runtime/core/module/connections.h"
#include "runtime/training/learning/terminal_end.h"

namespace runtime {
namespace {

constexpr const char* kScheduled = "scheduled";
constexpr const char* kLearned = "learned";
constexpr const char* kKeep = "keep";  // of what belongs to a task, for the next one
constexpr const char* kForget = "forget";
constexpr const char* kPpoFormat = "ppo_1";  // of a checkpoint
constexpr int kLargestLayer = 4096;
constexpr double kLargestCorrelation = 0.999;
constexpr double kLargestNumber = 1e15;  // that is observed: its square is a float

}  // namespace

Ppo::Ppo(std::string name, const Context& context)
    : Learner(std::move(name)),
      deviation_mode_(kScheduled),
      seed_(context.seed),
      random_(context.seed) {
  constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  const auto add = [this](const char* parameter, const char* doc, auto* target, double minimum,
                          double maximum) {
    AddParameter(
        {.name = parameter, .doc = doc, .target = target, .minimum = minimum, .maximum = maximum});
  };
  AddParameter({.name = "hidden",
                .doc = "units of each hidden layer, of the policy and of the value",
                .target = &hidden_,
                .minimum = 1,
                .maximum = kLargestLayer,
                .is_live = false});
  add("batch", "decisions that an update learns from, at least", &batch_, 1, kNoLimit);
  add("minibatch", "decisions that a step of the optimizer is from", &settings_.minibatch, 1,
      kNoLimit);
  add("epochs", "how often an update goes through its batch", &settings_.epochs, 1, kNoLimit);
  add("discount", "gamma, per action", &settings_.discount, 0, 1);
  add("gae_lambda", "lambda of the advantages", &settings_.gae_lambda, 0, 1);
  add("clip", "how far an action's probability pays off to change, relative to what it was",
      &settings_.clip, 0, kNoLimit);
  add("entropy_bonus", "weight of the entropy", &settings_.entropy_bonus, 0, kNoLimit);
  add("learning_rate", "of Adam for the policy, in the first update", &settings_.learning_rate, 0,
      kNoLimit);
  add("value_learning_rate", "of Adam for the value", &settings_.value_learning_rate, 0, kNoLimit);
  add("kl_target", "divergence that an update aims at by its learning rate; 0: the rate stays",
      &settings_.kl_target, 0, kNoLimit);
  add("gradient_max", "longer gradients are cut to this length", &settings_.gradient_max, 0,
      kNoLimit);
  AddParameter({.name = "deviation_mode",
                .doc = "how the standard deviation of actions changes: it is brought down, or it "
                       "is learned",
                .target = &deviation_mode_,
                .choices = {kScheduled, kLearned},
                .is_live = false});
  constexpr double kLeastDeviation = 1e-6;
  add("deviation", "standard deviation of actions in the first episode", &settings_.deviation,
      kLeastDeviation, kNoLimit);
  add("deviation_min", "it does not fall below this", &settings_.deviation_min, kLeastDeviation,
      kNoLimit);
  add("noise_correlation",
      "of what exploration adds to an action with what it added to the one before; 0: independent",
      &noise_correlation_, 0, kLargestCorrelation);
  add("deviation_decisions", "decisions over which it is brought down, in equal steps",
      &settings_.deviation_decisions, 0, kNoLimit);
  const auto add_choice = [this](const char* parameter, const char* doc, std::string* target) {
    *target = kKeep;
    AddParameter({.name = parameter, .doc = doc, .target = target, .choices = {kKeep, kForget}});
  };
  add_choice("new_task_value", "with a swapped task: what observations are worth",
             &new_task_value_);
  add_choice("new_task_scale", "with a swapped task: how large rewards are", &new_task_scale_);
  add_choice("new_task_optimizers",
             "with a swapped task: the moments and the rate of the optimizers",
             &new_task_optimizers_);
  AddCurve({"entropy", "", "of the distribution of actions", &shown_.entropy});
  AddCurve({"deviation", "", "standard deviation of actions", &shown_.deviation});
  AddCurve(
      {"divergence", "", "KL of the policy from the one before the update", &shown_.divergence});
  AddCurve({"learning_rate", "", "of Adam for the policy", &shown_.learning_rate});
  AddCurve({"policy_loss", "", "clipped, negative where the policy improves", &shown_.policy_loss});
  AddCurve({"value_loss", "", "half of the mean squared error", &shown_.value_loss});
  AddCurve({"explained_variance", "", "of what observations are worth, before the update; 1: all",
            &shown_.explained_variance});
}

void Ppo::Start() {
  RequireConnections(*this);
  HiddenSizes();
  settings_.learns_deviation = deviation_mode_ == kLearned;
  if (settings_.deviation_min <= settings_.deviation) return;
  throw UserError(fmt::format("`{0}.deviation_min` is {1}, more than `{0}.deviation` {2}", name(),
                              settings_.deviation_min, settings_.deviation));
}

std::vector<int> Ppo::HiddenSizes() const {
  std::vector<int> sizes;
  for (const double size : hidden_) {
    if (size != std::floor(size)) {
      throw UserError(
          fmt::format("`{}.hidden` are numbers of units, and {} is not whole", name(), size));
    }
    sizes.push_back(static_cast<int>(size));
  }
  return sizes;
}

void Ppo::PrepareState() {
  const auto observations = static_cast<int>(observation_in_().size());
  const int actions = action_size_in_();
  if (state_.action_size() == 0) {
    if (observations == 0) {
      throw UserError(fmt::format("`{}` gets an observation without elements", name()));
    }
    state_ = PpoState(observations, actions, HiddenSizes(), settings_.deviation, random_);
  }
  if (state_.observation_size() == observations && state_.action_size() == actions) {
    action_.setZero(actions);
    action_out_.setZero(actions);
    noise_.setZero(actions);
    return;
  }
  throw UserError(fmt::format(
      "`{}` has learned with observations of {} elements and actions of {}, and the agent has {} "
      "and {}: continue with those that it was trained with, or start over",
      name(), state_.observation_size(), state_.action_size(), observations, actions));
}

void Ppo::SelectFirst() {
  PrepareState();
  action_random_ = Random(EpisodeSeed(seed_, episode()));
  if (learns_) DrawNoise(0);
  Select();
}

void Ppo::Observe() {
  const Eigen::VectorXd& observation = observation_in_();
  if (observation.size() != state_.observation_size()) PrepareState();
  observation_ = observation.cwiseMax(-kLargestNumber).cwiseMin(kLargestNumber).cast<float>();
}

// Noise that is much the same for a while takes the robot to postures that independent noise does
// not: the joints average that out (Eberhard et al., "Pink noise is all you need", 2023).
void Ppo::DrawNoise(double correlation) {
  const auto kept = static_cast<float>(correlation);
  const auto fresh = static_cast<float>(std::sqrt(1 - correlation * correlation));
  for (float& noise : noise_)
    noise = kept * noise + fresh * static_cast<float>(action_random_.Normal());
}

void Ppo::Select() {
  Observe();
  normalized_ = observation_;
  state_.Normalize(normalized_);
  action_ = state_.policy.mean.Forward(normalized_, pass_).col(0);
  if (learns_) action_.array() += state_.policy.log_deviations.array().exp() * noise_.array();
  action_out_ = action_.cast<double>();
  has_credit_ = learns_;
}

void Ppo::Note(double reward) {
  if (has_credit_) state_.batch.Add(observation_, action_, reward);
}

void Ppo::LearnAndSelect(double reward) {
  Note(reward);
  if (learns_) DrawNoise(noise_correlation_);
  Select();
}

void Ppo::LearnFromEnd(double reward, const EpisodeEnd& end) {
  Note(reward);
  Observe();
  state_.batch.EndEpisode(observation_, IsTerminal(end.kind));
}

void Ppo::FinishEpisode() {
  state_.batch.DropUnfinished();
  if (const auto episodes = static_cast<double>(state_.batch.episodes().size()); episodes > 0) {
    episode_decisions_ = state_.batch.decisions() / episodes;
  }
  if (state_.batch.decisions() >= batch_) {
    const int passed_over = update_.Learn(settings_, state_, random_);
    for (int i = 0; i < passed_over; ++i) NotePassedOver();
    NoteNewPolicy();
  }
  shown_ = state_.figures;
}

int64_t Ppo::EpisodesAlike() const {
  if (state_.action_size() == 0 || episode_decisions_ == 0) return 1;
  const int missing = batch_ - state_.batch.decisions();
  return std::max<int64_t>(1, static_cast<int64_t>(std::ceil(missing / episode_decisions_)));
}

void Ppo::ActLike(const Learner& leader) {
  state_.ActLike(dynamic_cast<const Ppo&>(leader).state_);
}

void Ppo::Collect(const Learner& follower) {
  state_.batch.Append(dynamic_cast<const Ppo&>(follower).state_.batch);
}

void Ppo::ForgetCredit() {
  state_.batch.Clear();
  has_credit_ = false;
  if (state_.action_size() == 0) return;
  if (new_task_value_ == kForget) state_.ForgetValue(random_);
  if (new_task_scale_ == kForget) state_.ForgetScale();
  if (new_task_optimizers_ == kForget) state_.ForgetOptimizers();
}

void Ppo::Forget() {
  state_ = PpoState();
  has_credit_ = false;
}

PolicyGraph::Value Ppo::AddTo(PolicyGraph& graph, PolicyGraph::Value observation) const {
  if (state_.action_size() > 0) return state_.AddPolicy(graph, observation);
  throw UserError(fmt::format("`{}` has no policy before its first episode", name()));
}

void Ppo::Save(std::ostream& out) const {
  out << kPpoFormat << ' ' << random_ << ' ' << (state_.action_size() > 0) << ' ';
  if (state_.action_size() > 0) state_.Save(out);
}

void Ppo::Load(std::istream& in) {
  std::string format;
  Random random(0);
  bool has_state = false;
  in >> format >> random >> has_state;
  const bool is_known = in && format == kPpoFormat;
  PpoState state = is_known && has_state ? PpoState::Load(in) : PpoState();
  if (!is_known || !in) {
    throw UserError(fmt::format("the checkpoint of `{}` is damaged or of another version", name()));
  }
  random_ = random;
  state_ = std::move(state);
}

}  // namespace runtime
